<?xml version="1.0" encoding="utf-8"?>
<!DOCTYPE TS>
<TS version="2.1" language="zh_CN">
<context>
    <name>About</name>
    <message>
        <source>Commissions a robotic abrasive-belt grinding cell for turbine blades: six steps, each checked on data that its fit has not seen.</source>
        <translation>调试用于涡轮叶片的机器人砂带磨削单元：六个步骤，每一步都用其拟合未使用的数据检验。</translation>
    </message>
    <message>
        <source>Engine: {version}</source>
        <translation>引擎：{version}</translation>
    </message>
    <message>
        <source>This program is not a safety function.</source>
        <translation>本程序不是安全功能。</translation>
    </message>
    <message>
        <source>It asks for motions and can ask for a stop. Whatever protects people is the cell&apos;s own: guards, enabling switch, emergency stop.</source>
        <translation>它请求移动，也可以请求停止。保护人员的是单元自身的装置：防护罩、使能开关、急停。</translation>
    </message>
    <message>
        <source>About beltcal</source>
        <translation>关于 beltcal</translation>
    </message>
</context>
<context>
    <name>Banner</name>
    <message>
        <source>Accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>Good — can be accepted</source>
        <translation>合格 — 可以接受</translation>
    </message>
    <message>
        <source>Rejected</source>
        <translation>已拒绝</translation>
    </message>
    <message>
        <source>Provisional</source>
        <translation>暂定</translation>
    </message>
    <message>
        <source>No result yet</source>
        <translation>尚无结果</translation>
    </message>
    <message>
        <source>Stale</source>
        <translation>已失效</translation>
    </message>
    <message>
        <source>Cannot begin yet</source>
        <translation>尚不能开始</translation>
    </message>
    <message>
        <source>Failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Copy</source>
        <translation>复制</translation>
    </message>
    <message>
        <source>Copy this text</source>
        <translation>复制此文本</translation>
    </message>
    <message>
        <source>Copy the verdict</source>
        <translation>复制判定</translation>
    </message>
    <message>
        <source>Less ▴</source>
        <translation>收起 ▴</translation>
    </message>
    <message>
        <source>More ▾</source>
        <translation>更多 ▾</translation>
    </message>
    <message>
        <source>Less of the verdict</source>
        <translation>收起判定</translation>
    </message>
    <message>
        <source>More of the verdict</source>
        <translation>展开判定</translation>
    </message>
</context>
<context>
    <name>Beside</name>
    <message>
        <source>&amp;Close</source>
        <translation>关闭(&amp;C)</translation>
    </message>
</context>
<context>
    <name>Card</name>
    <message>
        <source>Skip</source>
        <translation>跳过</translation>
    </message>
    <message>
        <source>Back</source>
        <translation>上一步</translation>
    </message>
    <message>
        <source>Done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>Next</source>
        <translation>下一步</translation>
    </message>
</context>
<context>
    <name>ChecksList</name>
    <message>
        <source>Check on held-out data</source>
        <translation>用留出数据检验</translation>
    </message>
    <message>
        <source>, limit {limit}{unit}</source>
        <translation>，限值 {limit}{unit}</translation>
    </message>
    <message>
        <source> — not known yet</source>
        <translation> — 尚不清楚</translation>
    </message>
    <message>
        <source> (n = {count})</source>
        <translation>（n = {count}）</translation>
    </message>
</context>
<context>
    <name>CompareDialog</name>
    <message>
        <source>Compared with {name}</source>
        <translation>与 {name} 比较</translation>
    </message>
    <message>
        <source>A number has changed where it moved by more than both uncertainties together (k = 2) allow.</source>
        <translation>当数值的变化超过两者不确定度之和（k = 2）所允许的范围时，视为已改变。</translation>
    </message>
    <message>
        <source>Numbers of both sessions</source>
        <translation>两个会话的数值</translation>
    </message>
    <message>
        <source>Step</source>
        <translation>步骤</translation>
    </message>
    <message>
        <source>What</source>
        <translation>项目</translation>
    </message>
    <message>
        <source>This session</source>
        <translation>本会话</translation>
    </message>
    <message>
        <source>The other</source>
        <translation>另一会话</translation>
    </message>
    <message>
        <source>Moved</source>
        <translation>变化量</translation>
    </message>
    <message>
        <source>By chance up to (k = 2)</source>
        <translation>随机变化上限（k = 2）</translation>
    </message>
    <message>
        <source>◆ changed</source>
        <translation>◆ 已改变</translation>
    </message>
    <message>
        <source>✔ the same</source>
        <translation>✔ 相同</translation>
    </message>
</context>
<context>
    <name>DeviceStrip</name>
    <message>
        <source>Devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>{person} works on blade type {blade_type}, serial {serial}</source>
        <translation>{person} 操作叶片型号 {blade_type}，序列号 {serial}</translation>
    </message>
    <message>
        <source>{person} works on blade type {blade_type}</source>
        <translation>{person} 操作叶片型号 {blade_type}</translation>
    </message>
    <message>
        <source>{state} since {time}</source>
        <translation>自 {time} 起{state}</translation>
    </message>
</context>
<context>
    <name>Doors</name>
    <message>
        <source>Open the session in this folder</source>
        <translation>打开此文件夹中的会话</translation>
    </message>
    <message>
        <source>Look at the session in this folder</source>
        <translation>查看此文件夹中的会话</translation>
    </message>
    <message>
        <source>Compare with the session in this folder</source>
        <translation>与此文件夹中的会话比较</translation>
    </message>
    <message>
        <source>Export is locked:</source>
        <translation>导出已锁定：</translation>
    </message>
</context>
<context>
    <name>ErrorSurfacePanel</name>
    <message>
        <source>Rejected points</source>
        <translation>剔除的点</translation>
    </message>
    <message>
        <source>Robot programs</source>
        <translation>机器人程序</translation>
    </message>
    <message>
        <source>Write robot programs …</source>
        <translation>写出机器人程序 …</translation>
    </message>
    <message>
        <source>Export is locked:</source>
        <translation>导出已锁定：</translation>
    </message>
</context>
<context>
    <name>ExportDialog</name>
    <message>
        <source>Write robot programs</source>
        <translation>写出机器人程序</translation>
    </message>
    <message>
        <source>Write robot programs and report</source>
        <translation>写出机器人程序和报告</translation>
    </message>
    <message>
        <source>To this folder; it is made if there is none:</source>
        <translation>写到此文件夹；若不存在则新建：</translation>
    </message>
    <message>
        <source>C&amp;hoose…</source>
        <translation>选择(&amp;H)…</translation>
    </message>
    <message>
        <source>Choose another folder</source>
        <translation>选择其他文件夹</translation>
    </message>
    <message>
        <source>&amp;Write</source>
        <translation>写出(&amp;W)</translation>
    </message>
    <message>
        <source>Folder for robot programs and report</source>
        <translation>机器人程序和报告的文件夹</translation>
    </message>
</context>
<context>
    <name>ExportedDialog</name>
    <message>
        <source>Exported</source>
        <translation>已导出</translation>
    </message>
    <message>
        <source>✔ {count} files were written to {folder}</source>
        <translation>✔ 已将 {count} 个文件写入 {folder}</translation>
    </message>
    <message>
        <source>Files that were written</source>
        <translation>已写出的文件</translation>
    </message>
    <message>
        <source>&amp;Open the folder</source>
        <translation>打开文件夹(&amp;O)</translation>
    </message>
</context>
<context>
    <name>FaultDialog</name>
    <message>
        <source>A fault of the program</source>
        <translation>程序故障</translation>
    </message>
    <message>
        <source>This is not your mistake. What was taken is kept. Copy the text below and give it to whoever looks after the program.</source>
        <translation>这不是您的错误。已采集的内容都已保存。请复制下面的文本并交给维护本程序的人员。</translation>
    </message>
    <message>
        <source>Text of the fault</source>
        <translation>故障文本</translation>
    </message>
    <message>
        <source>Co&amp;py</source>
        <translation>复制(&amp;P)</translation>
    </message>
</context>
<context>
    <name>FinePanel</name>
    <message>
        <source>Faces chosen: {count}. Click a face of the CAD model to choose it or to take it off.</source>
        <translation>已选面：{count} 个。点击 CAD 模型的面可选中或取消。</translation>
    </message>
    <message>
        <source>Reset to the blade type&apos;s faces</source>
        <translation>恢复为叶片型号默认的面</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Colours of the scan</source>
        <translation>扫描的着色</translation>
    </message>
    <message>
        <source>Colour: face by face</source>
        <translation>颜色：逐面</translation>
    </message>
    <message>
        <source>Colour: {what}</source>
        <translation>颜色：{what}</translation>
    </message>
</context>
<context>
    <name>Help</name>
    <message>
        <source>The residual is too large</source>
        <translation>残差过大</translation>
    </message>
    <message>
        <source>The samples do not agree with each other. Untick the sample marked as worst. If the rest agrees, delete it and take it again; if not, check that everything is clamped and nothing moved.</source>
        <translation>样本之间不一致。请取消勾选标为最差的样本。若其余样本一致，将其删除并重新采集；否则请检查是否全部夹紧、没有任何移动。</translation>
    </message>
    <message>
        <source>The check on held-out data fails</source>
        <translation>留出数据检验不合格</translation>
    </message>
    <message>
        <source>The result does not predict what it has not seen. Something moved between two samples, or one sample is wrong. A small residual does not help here: take the step&apos;s samples again.</source>
        <translation>结果不能预测它未见过的数据。两个样本之间有东西移动了，或者有一个样本错误。此时残差小也没有用：请重新采集该步骤的样本。</translation>
    </message>
    <message>
        <source>The uncertainty is too large</source>
        <translation>不确定度过大</translation>
    </message>
    <message>
        <source>The samples agree, but do not tell enough. Add the pose or touch that is suggested.</source>
        <translation>样本一致，但信息不足。请增加建议的位姿或触测。</translation>
    </message>
    <message>
        <source>Too little variation, or ill-conditioned</source>
        <translation>变化太少，或病态</translation>
    </message>
    <message>
        <source>The samples are too much alike, so one direction is not held. Tilt further and about other axes, or scan from another side.</source>
        <translation>样本彼此太相似，因此有一个方向没有约束。请加大倾斜并绕其他轴倾斜，或从另一侧扫描。</translation>
    </message>
    <message>
        <source>Too few points, or too little of the surface seen</source>
        <translation>点太少，或看到的表面太少</translation>
    </message>
    <message>
        <source>Move the scanner closer or look from another side; clean what is measured.</source>
        <translation>请将扫描仪移近或从另一侧观察；清洁被测物。</translation>
    </message>
    <message>
        <source>Too many outliers</source>
        <translation>离群点过多</translation>
    </message>
    <message>
        <source>Something strange is in the picture: dirt, a clamp, a reflection. Take it away and scan again.</source>
        <translation>画面中有异物：污物、夹具、反光。请移除后重新扫描。</translation>
    </message>
    <message>
        <source>No redundancy</source>
        <translation>没有冗余</translation>
    </message>
    <message>
        <source>A mistake could hide, because nothing checks a single sample. Tick samples again or take more.</source>
        <translation>错误可能被掩盖，因为没有数据能检验单个样本。请重新勾选样本或采集更多。</translation>
    </message>
    <message>
        <source>Outside the limits, or the wrong model</source>
        <translation>超出限值，或模型错误</translation>
    </message>
    <message>
        <source>The result agrees with itself but cannot be true, such as a wrong ball diameter or blade type. Check what is mounted against what was entered.</source>
        <translation>结果自洽但不可能正确，例如标准球直径或叶片型号错误。请核对实际安装的与输入的是否一致。</translation>
    </message>
    <message>
        <source>Finds where the scanner sits on its stage, and how the stage&apos;s axes really run. Every later scan is placed by this result.</source>
        <translation>确定扫描仪在位移台上的位置，以及位移台各轴的实际走向。之后的每次扫描都由此结果定位。</translation>
    </message>
    <message>
        <source>The scanned ball in the 3D view: a wide cap should be seen in every scan. The last scan repeats the first one; if the ball has moved in between, the check says so.</source>
        <translation>三维视图中扫描到的标准球：每次扫描都应看到较大的球冠。最后一次扫描重复第一次；若标准球期间移动过，检验会指出。</translation>
    </message>
    <message>
        <source>One scan stands out</source>
        <translation>有一次扫描异常</translation>
    </message>
    <message>
        <source>Untick it and look whether the check gets better. Delete it and press the main button to take it again.</source>
        <translation>取消勾选它，看检验是否变好。删除它并按主按钮重新采集。</translation>
    </message>
    <message>
        <source>The ball&apos;s diameter does not fit</source>
        <translation>标准球直径不符</translation>
    </message>
    <message>
        <source>Another ball is mounted than the one in the cell&apos;s file, or it is dirty. Clean it, or check the certificate.</source>
        <translation>安装的球与单元文件中的不同，或球脏污。请清洁，或核对证书。</translation>
    </message>
    <message>
        <source>The closing scan is off</source>
        <translation>收尾扫描有偏差</translation>
    </message>
    <message>
        <source>The ball or its holder has moved. Fasten it and start the step over.</source>
        <translation>标准球或其支座移动了。请紧固并重新开始此步骤。</translation>
    </message>
    <message>
        <source>Finds where the measuring frame is in the robot&apos;s base frame, so that what is scanned can be reached by the robot.</source>
        <translation>确定测量坐标系在机器人基坐标系中的位置，使机器人能够到达扫描到的位置。</translation>
    </message>
    <message>
        <source>Mount the reference ball on the robot&apos;s flange and tighten it; wipe it clean. The robot brings it in front of the scanner and then stands still, while the stage moves the scanner about it.</source>
        <translation>将标准球安装在机器人法兰上并拧紧，擦拭干净。机器人将它送到扫描仪前方后静止不动，位移台带动扫描仪绕其移动。</translation>
    </message>
    <message>
        <source>The reference ball stays on the robot&apos;s flange as it was in the ball step. Keep the robot&apos;s way in front of the scanner free: the robot moves to many poses in this step.</source>
        <translation>标准球保持标准球步骤中的状态留在机器人法兰上。保持扫描仪前方机器人的通路无障碍：此步骤中机器人会移动到多个位姿。</translation>
    </message>
    <message>
        <source>The poses should tilt the flange about different axes. The path of each motion is shown before it is asked for; look at it before you confirm.</source>
        <translation>各位姿应绕不同的轴倾斜法兰。每次移动的路径在请求之前显示；确认前请查看。</translation>
    </message>
    <message>
        <source>One pose stands out</source>
        <translation>有一个位姿异常</translation>
    </message>
    <message>
        <source>Untick it. If the others agree, take it again; a cable may have pulled or the ball was hidden in part.</source>
        <translation>取消勾选它。若其他位姿一致，请重新采集它；可能是线缆牵拉，或标准球被部分遮挡。</translation>
    </message>
    <message>
        <source>All poses are a little off</source>
        <translation>所有位姿都略有偏差</translation>
    </message>
    <message>
        <source>The ball on the flange is loose, or the robot was re-mastered. Tighten and take all again.</source>
        <translation>法兰上的标准球松动，或机器人重新校准过零点。请拧紧并全部重新采集。</translation>
    </message>
    <message>
        <source>Too little variation</source>
        <translation>变化太少</translation>
    </message>
    <message>
        <source>Take the suggested pose: it tilts the flange where the result is weakest.</source>
        <translation>请采集建议的位姿：它在结果最薄弱的方向倾斜法兰。</translation>
    </message>
    <message>
        <source>Finds roughly where the blade is clamped, so that the fine step can begin. A few millimetres are good enough here.</source>
        <translation>粗略确定叶片的装夹位置，以便精定位步骤开始。这里几毫米的精度就够了。</translation>
    </message>
    <message>
        <source>Clamp the blade by its root in the gripper on the flange. Check that type and serial number are those at the top of this window.</source>
        <translation>用法兰上的夹爪夹住叶片榫头。请核对型号和序列号与窗口顶部一致。</translation>
    </message>
    <message>
        <source>Scan and CAD model lie on each other in the 3D view. If the blade looks mirrored or turned by half a turn, do not accept.</source>
        <translation>在三维视图中扫描与 CAD 模型应重合。若叶片看起来镜像或转了半圈，请不要接受。</translation>
    </message>
    <message>
        <source>No place was found automatically</source>
        <translation>没有自动找到位置</translation>
    </message>
    <message>
        <source>Choose picking by hand and click at least four corners that you see in both pictures, far from each other and not in one line.</source>
        <translation>请选择手动选点，并点击至少四个在两幅画面中都能看到的角点，彼此远离且不在一条直线上。</translation>
    </message>
    <message>
        <source>One pair of picks stands out</source>
        <translation>有一个点对异常</translation>
    </message>
    <message>
        <source>Delete this pair and pick it again; zoom in before you click.</source>
        <translation>删除该点对并重新选取；点击前请放大。</translation>
    </message>
    <message>
        <source>The blade is found the wrong way round</source>
        <translation>找到的叶片方向反了</translation>
    </message>
    <message>
        <source>Check the blade type. Then pick by hand.</source>
        <translation>请检查叶片型号。然后手动选取。</translation>
    </message>
    <message>
        <source>Finds exactly where the blade is, from the faces of its root and shroud. This pose places every contact of the belt.</source>
        <translation>根据榫头和叶冠的面精确确定叶片的位置。砂带的每个接触点都由此位姿确定。</translation>
    </message>
    <message>
        <source>Leave the blade as it was clamped for the rough step. If it was touched or clamped again, repeat the rough step.</source>
        <translation>保持叶片在粗定位步骤中的装夹状态。若被碰过或重新装夹，请重做粗定位步骤。</translation>
    </message>
    <message>
        <source>The deviation of each chosen face, in µm with its sign. A face that is off by itself is dirty, damaged or badly seen.</source>
        <translation>每个所选面的偏差，以 µm 计并带符号。单独偏离的面是脏污、损坏或扫描不佳的。</translation>
    </message>
    <message>
        <source>One face is off</source>
        <translation>有一个面偏离</translation>
    </message>
    <message>
        <source>Clean it and scan again, or take it off the list if the other faces hold the blade in every direction.</source>
        <translation>清洁后重新扫描；若其他面在每个方向都能约束叶片，也可将其从列表中去掉。</translation>
    </message>
    <message>
        <source>A face has too few points</source>
        <translation>有一个面的点太少</translation>
    </message>
    <message>
        <source>It is hidden or seen too flat. Scan from another side, or take it off the list.</source>
        <translation>它被遮挡或视角太平。请从另一侧扫描，或将其从列表中去掉。</translation>
    </message>
    <message>
        <source>The blade has slipped in its clamp. Clamp it again and repeat from the rough step.</source>
        <translation>叶片在夹具中滑动了。请重新装夹，并从粗定位步骤开始重做。</translation>
    </message>
    <message>
        <source>Finds the tip of the stylus, and with it the contact wheel of each grinder in the robot&apos;s base frame.</source>
        <translation>确定测针针尖，并由此确定每台砂带磨床的接触轮在机器人基坐标系中的位置。</translation>
    </message>
    <message>
        <source>Mount the stylus on the flange. Belts stand still and are locked out: you work at the wheel by hand. Set the tip into the cone first, then to the centre mark of each wheel&apos;s shaft.</source>
        <translation>将测针安装在法兰上。砂带静止并已锁定：您要在接触轮处手动操作。先将针尖放入锥窝，再依次放到每个轮轴的中心标记上。</translation>
    </message>
    <message>
        <source>In the cone: tilt the flange widely and about different axes, the tip must not lift. At the wheel: turn the floating head between touches; a longer arc gives a better axis.</source>
        <translation>在锥窝中：大幅并绕不同的轴倾斜法兰，针尖不得抬起。在接触轮处：在两次触测之间转动浮动头；弧段越长，轴越准确。</translation>
    </message>
    <message>
        <source>One touch stands out</source>
        <translation>有一次触测异常</translation>
    </message>
    <message>
        <source>The tip was not seated. Delete this touch and take it again.</source>
        <translation>针尖没有坐实。请删除该触测并重新采集。</translation>
    </message>
    <message>
        <source>The arc is too short</source>
        <translation>弧段太短</translation>
    </message>
    <message>
        <source>Turn the head further, as far as the reason says, and add touches there.</source>
        <translation>将浮动头转得更大，直到判定理由所说的程度，并在那里增加触测。</translation>
    </message>
    <message>
        <source>Radius or sensor scale does not fit</source>
        <translation>半径或传感器比例不符</translation>
    </message>
    <message>
        <source>The wheel is worn or another one, or the sensor is set wrongly. Check both before going on.</source>
        <translation>接触轮磨损或是另一个，或传感器设置错误。继续之前请两者都检查。</translation>
    </message>
    <message>
        <source>Touches the airfoil with the standing wheel of each grinder, maps what is left of all errors along the surface normal, and corrects the grinding path by it.</source>
        <translation>用每台砂带磨床静止的接触轮触碰叶身，绘出沿曲面法线方向的全部剩余误差，并据此修正磨削路径。</translation>
    </message>
    <message>
        <source>The blade is clamped as in the fine step. Belts stand still, nothing touches the floating heads before the robot does.</source>
        <translation>叶片的装夹与精定位步骤相同。砂带静止，在机器人之前不得有任何东西触碰浮动头。</translation>
    </message>
    <message>
        <source>The map should be smooth. The band shows how sure it is; where nothing was touched, nothing is corrected. The prediction compares the blade with and without correction.</source>
        <translation>误差图应当平滑。色带表示其可信程度；没有触碰的地方不作修正。预测比较修正前后的叶片。</translation>
    </message>
    <message>
        <source>Held-out touches are predicted badly</source>
        <translation>留出的触测预测不佳</translation>
    </message>
    <message>
        <source>The head sticks, or the blade slips under the touch. Check both, then start the step over.</source>
        <translation>浮动头卡滞，或叶片在触碰时滑动。请两者都检查，然后重新开始此步骤。</translation>
    </message>
    <message>
        <source>Too little of the airfoil was touched</source>
        <translation>触碰到的叶身太少</translation>
    </message>
    <message>
        <source>Some places were out of reach. Look at the map and free the robot&apos;s way.</source>
        <translation>有些位置无法到达。请查看误差图并清除机器人通路上的障碍。</translation>
    </message>
    <message>
        <source>The head no longer rests where it did</source>
        <translation>浮动头不再停在原来的位置</translation>
    </message>
    <message>
        <source>The zero of its angle sensor has shifted. Repeat the step Stylus and tool.</source>
        <translation>其角度传感器的零点偏移了。请重做“测针与工具”步骤。</translation>
    </message>
</context>
<context>
    <name>HelpPanel</name>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>Help of this step</source>
        <translation>此步骤的帮助</translation>
    </message>
    <message>
        <source>What it is for</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>What to mount</source>
        <translation>要安装什么</translation>
    </message>
    <message>
        <source>What to watch</source>
        <translation>注意什么</translation>
    </message>
    <message>
        <source>Nothing has been taken yet.</source>
        <translation>尚未采集任何内容。</translation>
    </message>
    <message>
        <source>Samples are being taken, or a result waits to be accepted.</source>
        <translation>正在采集样本，或结果等待接受。</translation>
    </message>
    <message>
        <source>Checked on held-out data and accepted by a person.</source>
        <translation>已用留出数据检验并由人员接受。</translation>
    </message>
    <message>
        <source>Something it stands on has changed. Solve or take it again; export is locked.</source>
        <translation>它所依据的内容已改变。请重新求解或采集；导出已锁定。</translation>
    </message>
    <message>
        <source>Rejected; the banner says why and what to do.</source>
        <translation>被拒绝；横幅说明原因和处理办法。</translation>
    </message>
    <message>
        <source>± (k = 2)</source>
        <translation>±（k = 2）</translation>
    </message>
    <message>
        <source>Twice the standard uncertainty: 95 times of 100 the true value is in it.</source>
        <translation>标准不确定度的两倍：100 次中有 95 次真值在其范围内。</translation>
    </message>
    <message>
        <source>Residual</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>How far a sample is from the result that was fitted to it. Small residuals alone prove nothing.</source>
        <translation>样本与由它拟合的结果之间的距离。仅凭残差小不能证明什么。</translation>
    </message>
    <message>
        <source>Held-out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>Kept out of the fit and used to check how well the result predicts.</source>
        <translation>不参与拟合，用来检验结果的预测能力。</translation>
    </message>
    <message>
        <source>Frames</source>
        <translation>坐标系</translation>
    </message>
    <message>
        <source>{B} robot base, {F} flange, {M} measuring stage, {S} scanner, {W} blade in CAD, {H} contact wheel. Lengths in mm, angles in degrees.</source>
        <translation>{B} 机器人基座，{F} 法兰，{M} 测量位移台，{S} 扫描仪，{W} CAD 中的叶片，{H} 接触轮。长度单位 mm，角度单位度。</translation>
    </message>
</context>
<context>
    <name>Keyboard</name>
    <message>
        <source>Stop every motion at once</source>
        <translation>立即停止所有移动</translation>
    </message>
    <message>
        <source>Look at a step</source>
        <translation>查看一个步骤</translation>
    </message>
    <message>
        <source>Step before, step after</source>
        <translation>上一步骤、下一步骤</translation>
    </message>
    <message>
        <source>Next, previous control</source>
        <translation>下一个、上一个控件</translation>
    </message>
    <message>
        <source>Space</source>
        <translation>空格</translation>
    </message>
    <message>
        <source>Press a button, tick a sample; hold it on the motion button to keep moving</source>
        <translation>按下按钮，勾选样本；在移动按钮上按住可持续移动</translation>
    </message>
    <message>
        <source>The next thing to do (the large coloured button)</source>
        <translation>下一步要做的事（大的彩色按钮）</translation>
    </message>
    <message>
        <source>Undo, redo an edit of the step&apos;s samples</source>
        <translation>撤销、重做此步骤样本的编辑</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
    <message>
        <source>Delete the chosen sample</source>
        <translation>删除所选样本</translation>
    </message>
    <message>
        <source>New session, open, open read-only</source>
        <translation>新建会话、打开、以只读方式打开</translation>
    </message>
    <message>
        <source>Export robot programs and report</source>
        <translation>导出机器人程序和报告</translation>
    </message>
    <message>
        <source>Larger, smaller, usual text</source>
        <translation>放大、缩小、标准文字</translation>
    </message>
    <message>
        <source>3D view in a window of its own; there: the whole screen, Esc closes it</source>
        <translation>在独立窗口中显示三维视图；在该窗口中：全屏，按 Esc 关闭</translation>
    </message>
    <message>
        <source>Help of the step</source>
        <translation>此步骤的帮助</translation>
    </message>
    <message>
        <source>Alt + underlined letter</source>
        <translation>Alt + 带下划线的字母</translation>
    </message>
    <message>
        <source>Menu or button</source>
        <translation>菜单或按钮</translation>
    </message>
    <message>
        <source>Keyboard</source>
        <translation>键盘</translation>
    </message>
</context>
<context>
    <name>LiveValues</name>
    <message>
        <source>Live values: {values}</source>
        <translation>实时值：{values}</translation>
    </message>
    <message>
        <source>▶ moves, {speed}</source>
        <translation>▶ 移动中，{speed}</translation>
    </message>
    <message>
        <source>■ stands still</source>
        <translation>■ 静止</translation>
    </message>
    <message>
        <source>Flange in {B}: </source>
        <translation>法兰在 {B} 中：</translation>
    </message>
    <message>
        <source>Robot: </source>
        <translation>机器人：</translation>
    </message>
    <message>
        <source>Stage: </source>
        <translation>位移台：</translation>
    </message>
    <message>
        <source>Head, grinder {name}: {value}</source>
        <translation>浮动头，{name}砂带磨床：{value}</translation>
    </message>
    <message>
        <source>Force, grinder {name}: {value}</source>
        <translation>力，{name}砂带磨床：{value}</translation>
    </message>
</context>
<context>
    <name>Lock</name>
    <message>
        <source>{step}: nothing has been taken yet.</source>
        <translation>{step}：尚未采集任何内容。</translation>
    </message>
</context>
<context>
    <name>MainWindow</name>
    <message>
        <source>New here? A tour of two minutes shows what is where; it is also in the Help menu.</source>
        <translation>第一次使用？两分钟的导览会说明各部分的位置；“帮助”菜单中也有。</translation>
    </message>
    <message>
        <source>&amp;Take the tour</source>
        <translation>观看导览(&amp;T)</translation>
    </message>
    <message>
        <source>Cancelled. What was taken is kept.</source>
        <translation>已取消。已采集的内容都已保存。</translation>
    </message>
    <message>
        <source>Stopped. What was taken is kept; begin again when it is safe.</source>
        <translation>已停止。已采集的内容都已保存；确认安全后再重新开始。</translation>
    </message>
    <message>
        <source>The program has a fault. What was taken is kept.</source>
        <translation>程序发生故障。已采集的内容都已保存。</translation>
    </message>
    <message>
        <source>The engine has ended; nothing is asked of the cell any more. Everything that was taken is kept.</source>
        <translation>引擎已结束；不再向单元请求任何操作。已采集的内容都已保存。</translation>
    </message>
    <message>
        <source>Start it &amp;again</source>
        <translation>重新启动引擎(&amp;A)</translation>
    </message>
    <message>
        <source>The engine is starting…</source>
        <translation>正在启动引擎…</translation>
    </message>
    <message>
        <source>The engine has ended, so no motion is asked for. In danger use the emergency stop.</source>
        <translation>引擎已结束，因此不再请求任何移动。遇险请使用急停。</translation>
    </message>
    <message>
        <source>Stop has been sent.</source>
        <translation>已发送停止。</translation>
    </message>
    <message>
        <source>Stop has been sent; nothing was under way.</source>
        <translation>已发送停止；当时没有任何动作。</translation>
    </message>
    <message>
        <source>The picture is being prepared…</source>
        <translation>正在准备画面…</translation>
    </message>
    <message>
        <source>beltcal – simulated cell</source>
        <translation>beltcal – 模拟单元</translation>
    </message>
    <message>
        <source>{session} – beltcal, simulated cell</source>
        <translation>{session} – beltcal，模拟单元</translation>
    </message>
    <message>
        <source>Read-only: you look at this session, nothing can be changed.</source>
        <translation>只读：您正在查看此会话，不能更改任何内容。</translation>
    </message>
    <message>
        <source>Stopping, then closing. Everything is kept; nothing needs saving.</source>
        <translation>正在停止，随后关闭。所有内容都已保存，无需再存。</translation>
    </message>
</context>
<context>
    <name>Menus</name>
    <message>
        <source>&amp;Session</source>
        <translation>会话(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;New…</source>
        <translation>新建(&amp;N)…</translation>
    </message>
    <message>
        <source>&amp;Open…</source>
        <translation>打开(&amp;O)…</translation>
    </message>
    <message>
        <source>Open &amp;read-only…</source>
        <translation>以只读方式打开(&amp;R)…</translation>
    </message>
    <message>
        <source>Re&amp;cent</source>
        <translation>最近的会话(&amp;C)</translation>
    </message>
    <message>
        <source>Co&amp;mpare with…</source>
        <translation>比较(&amp;M)…</translation>
    </message>
    <message>
        <source>&amp;Export…</source>
        <translation>导出(&amp;E)…</translation>
    </message>
    <message>
        <source>&amp;Quit</source>
        <translation>退出(&amp;Q)</translation>
    </message>
    <message>
        <source>Ste&amp;p</source>
        <translation>步骤(&amp;P)</translation>
    </message>
    <message>
        <source>Step &amp;before</source>
        <translation>上一步骤(&amp;B)</translation>
    </message>
    <message>
        <source>Step &amp;after</source>
        <translation>下一步骤(&amp;A)</translation>
    </message>
    <message>
        <source>&amp;Stop every motion at once</source>
        <translation>立即停止所有移动(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;View</source>
        <translation>视图(&amp;V)</translation>
    </message>
    <message>
        <source>As the &amp;system</source>
        <translation>跟随系统(&amp;S)</translation>
    </message>
    <message>
        <source>&amp;Light</source>
        <translation>浅色(&amp;L)</translation>
    </message>
    <message>
        <source>&amp;Dark</source>
        <translation>深色(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;3D view in a window of its own</source>
        <translation>在独立窗口中显示三维视图(&amp;3)</translation>
    </message>
    <message>
        <source>Lar&amp;ger text</source>
        <translation>放大文字(&amp;G)</translation>
    </message>
    <message>
        <source>S&amp;maller text</source>
        <translation>缩小文字(&amp;M)</translation>
    </message>
    <message>
        <source>&amp;Usual text</source>
        <translation>标准文字(&amp;U)</translation>
    </message>
    <message>
        <source>S&amp;imulation</source>
        <translation>模拟(&amp;I)</translation>
    </message>
    <message>
        <source>Let something go &amp;wrong (training)</source>
        <translation>让某处出错（培训）(&amp;W)</translation>
    </message>
    <message>
        <source>&amp;Speed of the next session</source>
        <translation>下一会话的速度(&amp;S)</translation>
    </message>
    <message>
        <source>{count} times real time</source>
        <translation>实时的 {count} 倍</translation>
    </message>
    <message>
        <source>&amp;Help</source>
        <translation>帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Help of the step</source>
        <translation>此步骤的帮助(&amp;H)</translation>
    </message>
    <message>
        <source>&amp;Tour</source>
        <translation>导览(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Keyboard…</source>
        <translation>键盘(&amp;K)…</translation>
    </message>
    <message>
        <source>&amp;About…</source>
        <translation>关于(&amp;A)…</translation>
    </message>
    <message>
        <source>(none)</source>
        <translation>（无）</translation>
    </message>
    <message>
        <source>The reference ball moves by 0.5 mm</source>
        <translation>标准球移动 0.5 mm</translation>
    </message>
    <message>
        <source>The blade slips in its clamp</source>
        <translation>叶片在夹具中滑动</translation>
    </message>
    <message>
        <source>The wheel of grinder fine is worn by 0.3 mm</source>
        <translation>精磨砂带磨床的接触轮磨损 0.3 mm</translation>
    </message>
    <message>
        <source>The zero of grinder fine&apos;s head sensor shifts by 0.1°</source>
        <translation>精磨砂带磨床的浮动头传感器零点偏移 0.1°</translation>
    </message>
    <message>
        <source>The scanner is lost</source>
        <translation>扫描仪断开</translation>
    </message>
    <message>
        <source>The robot is lost</source>
        <translation>机器人断开</translation>
    </message>
    <message>
        <source>The stage is lost</source>
        <translation>位移台断开</translation>
    </message>
    <message>
        <source>Grinder fine is lost</source>
        <translation>精磨砂带磨床断开</translation>
    </message>
    <message>
        <source>Put everything right again</source>
        <translation>全部恢复正常</translation>
    </message>
</context>
<context>
    <name>Names</name>
    <message>
        <source>not started</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>已失效</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>Scanner</source>
        <translation>扫描仪</translation>
    </message>
    <message>
        <source>Stage</source>
        <translation>位移台</translation>
    </message>
    <message>
        <source>Robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>Grinder rough</source>
        <translation>粗磨砂带磨床</translation>
    </message>
    <message>
        <source>Grinder fine</source>
        <translation>精磨砂带磨床</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>等待</translation>
    </message>
    <message>
        <source>no news</source>
        <translation>无消息</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
</context>
<context>
    <name>Notice</name>
    <message>
        <source>Detai&amp;ls…</source>
        <translation>详情(&amp;L)…</translation>
    </message>
    <message>
        <source>Close this message</source>
        <translation>关闭此消息</translation>
    </message>
</context>
<context>
    <name>NumberRow</name>
    <message>
        <source>± {spread} (k = 2)</source>
        <translation>± {spread}（k = 2）</translation>
    </message>
    <message>
        <source>▲ limit {limit}</source>
        <translation>▲ 限值 {limit}</translation>
    </message>
    <message>
        <source>limit {limit}</source>
        <translation>限值 {limit}</translation>
    </message>
</context>
<context>
    <name>NumbersPanel</name>
    <message>
        <source>Fewer numbers</source>
        <translation>收起数值</translation>
    </message>
    <message>
        <source>All {count} numbers</source>
        <translation>全部 {count} 个数值</translation>
    </message>
    <message>
        <source>Numbers of the result</source>
        <translation>结果的数值</translation>
    </message>
</context>
<context>
    <name>PlotsArea</name>
    <message>
        <source>Plots</source>
        <translation>图表</translation>
    </message>
    <message>
        <source>Show the whole plot again (Home). Drag to move, wheel to zoom.</source>
        <translation>重新显示整个图表（Home）。拖动平移，滚轮缩放。</translation>
    </message>
    <message>
        <source>Show the whole plot</source>
        <translation>显示整个图表</translation>
    </message>
</context>
<context>
    <name>Primary</name>
    <message>
        <source>Working …</source>
        <translation>进行中 …</translation>
    </message>
    <message>
        <source>Restoring the session …</source>
        <translation>正在恢复会话 …</translation>
    </message>
    <message>
        <source>Accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>Go on ({progress})</source>
        <translation>继续（{progress}）</translation>
    </message>
    <message>
        <source>Solve again</source>
        <translation>重新求解</translation>
    </message>
    <message>
        <source>Solve</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>Take more samples</source>
        <translation>采集更多样本</translation>
    </message>
    <message>
        <source>Next step: {step}</source>
        <translation>下一步骤：{step}</translation>
    </message>
    <message>
        <source>Write robot programs …</source>
        <translation>写出机器人程序 …</translation>
    </message>
</context>
<context>
    <name>ProgressLine</name>
    <message>
        <source>Progress</source>
        <translation>进度</translation>
    </message>
</context>
<context>
    <name>QuestionPanel</name>
    <message>
        <source>What you are asked to do</source>
        <translation>需要您做什么</translation>
    </message>
    <message>
        <source>&amp;Done</source>
        <translation>完成(&amp;D)</translation>
    </message>
    <message>
        <source>&amp;Not now</source>
        <translation>暂不(&amp;N)</translation>
    </message>
    <message>
        <source>&amp;Move once</source>
        <translation>移动一次(&amp;M)</translation>
    </message>
    <message>
        <source>The robot moves along the path shown, once, at reduced speed</source>
        <translation>机器人沿显示的路径以降低的速度移动一次</translation>
    </message>
    <message>
        <source>Hold to move</source>
        <translation>按住移动</translation>
    </message>
    <message>
        <source>The robot moves only while you hold this button or the Space key</source>
        <translation>只有按住此按钮或空格键时机器人才移动</translation>
    </message>
    <message>
        <source>the &amp;whole series of this step</source>
        <translation>本步骤的整个系列(&amp;W)</translation>
    </message>
    <message>
        <source>Do not ask again for the following motions of this step</source>
        <translation>本步骤后续的移动不再询问</translation>
    </message>
    <message>
        <source>Stop: top right, or F12. It is no safety function.</source>
        <translation>停止：右上角，或 F12。它不是安全功能。</translation>
    </message>
    <message>
        <source>The robot wants to move</source>
        <translation>机器人要移动</translation>
    </message>
    <message>
        <source>Touch with the stylus</source>
        <translation>用测针触测</translation>
    </message>
    <message>
        <source>Please mount</source>
        <translation>请安装</translation>
    </message>
    <message>
        <source>The robot moves while you hold</source>
        <translation>按住时机器人移动</translation>
    </message>
    <message>
        <source>Path {length}, {duration}, at most {speed} (limit {limit})</source>
        <translation>路径 {length}，{duration}，最高 {speed}（限值 {limit}）</translation>
    </message>
    <message>
        <source>▲ Too fast: it cannot be allowed.</source>
        <translation>▲ 过快：不能允许。</translation>
    </message>
</context>
<context>
    <name>Rhythm</name>
    <message>
        <source>prepare</source>
        <translation>准备</translation>
    </message>
    <message>
        <source>acquire</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>result</source>
        <translation>结果</translation>
    </message>
    <message>
        <source>check</source>
        <translation>检验</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
</context>
<context>
    <name>RhythmLine</name>
    <message>
        <source>Phase of the step: {phase}</source>
        <translation>步骤的阶段：{phase}</translation>
    </message>
</context>
<context>
    <name>RoughPanel</name>
    <message>
        <source>Find the blade automatically</source>
        <translation>自动查找叶片</translation>
    </message>
    <message>
        <source>Pick pairs of points</source>
        <translation>选取点对</translation>
    </message>
    <message>
        <source>Click a point on the scan, then the same point on the CAD model.</source>
        <translation>在扫描上点击一点，然后在 CAD 模型上点击同一点。</translation>
    </message>
    <message>
        <source>Forget the half picked pair</source>
        <translation>放弃选了一半的点对</translation>
    </message>
</context>
<context>
    <name>SamplesModel</name>
    <message>
        <source>Sample</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Use</source>
        <translation>用途</translation>
    </message>
    <message>
        <source>Remark</source>
        <translation>备注</translation>
    </message>
</context>
<context>
    <name>SamplesTable</name>
    <message>
        <source>Table of samples</source>
        <translation>样本表</translation>
    </message>
    <message>
        <source>↶ &amp;Undo</source>
        <translation>↶ 撤销(&amp;U)</translation>
    </message>
    <message>
        <source>Take back the last edit of this step (Ctrl+Z)</source>
        <translation>撤销此步骤的上一次编辑（Ctrl+Z）</translation>
    </message>
    <message>
        <source>Undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>↷ &amp;Redo</source>
        <translation>↷ 重做(&amp;R)</translation>
    </message>
    <message>
        <source>Do again what was taken back (Ctrl+Shift+Z)</source>
        <translation>重做被撤销的编辑（Ctrl+Shift+Z）</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>&amp;Delete</source>
        <translation>删除(&amp;D)</translation>
    </message>
    <message>
        <source>Delete the chosen sample (Del); undo brings it back</source>
        <translation>删除所选样本（Del）；可撤销恢复</translation>
    </message>
    <message>
        <source>Delete the chosen sample</source>
        <translation>删除所选样本</translation>
    </message>
    <message>
        <source>Only flagged</source>
        <translation>仅显示有标记的</translation>
    </message>
    <message>
        <source>Show only samples that are left out or have a remark</source>
        <translation>只显示被排除或有备注的样本</translation>
    </message>
    <message>
        <source>Leave out of the fit</source>
        <translation>排除出拟合</translation>
    </message>
    <message>
        <source>Take into the fit</source>
        <translation>纳入拟合</translation>
    </message>
    <message>
        <source>Delete</source>
        <translation>删除</translation>
    </message>
</context>
<context>
    <name>SceneView</name>
    <message>
        <source>start</source>
        <translation>起点</translation>
    </message>
    <message>
        <source>end</source>
        <translation>终点</translation>
    </message>
    <message>
        <source>Planned motion of the robot</source>
        <translation>机器人的计划移动</translation>
    </message>
    <message>
        <source>way of the flange</source>
        <translation>法兰的路径</translation>
    </message>
    <message>
        <source>Fit</source>
        <translation>适应</translation>
    </message>
    <message>
        <source>Everything into the picture (F, or a double click)</source>
        <translation>显示全部（F 键，或双击）</translation>
    </message>
    <message>
        <source>Front</source>
        <translation>前</translation>
    </message>
    <message>
        <source>Along +y: x to the right, z up (1)</source>
        <translation>沿 +y：x 向右，z 向上（1）</translation>
    </message>
    <message>
        <source>Side</source>
        <translation>侧</translation>
    </message>
    <message>
        <source>Along −x: y to the right, z up (2)</source>
        <translation>沿 −x：y 向右，z 向上（2）</translation>
    </message>
    <message>
        <source>Top</source>
        <translation>上</translation>
    </message>
    <message>
        <source>Along −z: x to the right, y up (3)</source>
        <translation>沿 −z：x 向右，y 向上（3）</translation>
    </message>
    <message>
        <source>Oblique</source>
        <translation>斜</translation>
    </message>
    <message>
        <source>From the front, right and above (4)</source>
        <translation>从前方、右方和上方（4）</translation>
    </message>
    <message>
        <source>Window</source>
        <translation>独立窗口</translation>
    </message>
    <message>
        <source>3D view in a window of its own</source>
        <translation>独立窗口中的三维视图</translation>
    </message>
    <message>
        <source>The same in a window of its own, drawn by the graphics card: large, or on another screen (F11)</source>
        <translation>在独立窗口中显示同一画面，由显卡绘制：可放大，或放到另一块屏幕上（F11）</translation>
    </message>
    <message>
        <source>Start the 3D view again</source>
        <translation>重新启动三维视图</translation>
    </message>
    <message>
        <source>3D view</source>
        <translation>三维视图</translation>
    </message>
    <message>
        <source>The 3D view has stopped. Nothing else is affected.</source>
        <translation>三维视图已停止。其他部分不受影响。</translation>
    </message>
    <message>
        <source>Nothing to show yet.</source>
        <translation>还没有可显示的内容。</translation>
    </message>
    <message>
        <source>The 3D view is being prepared.</source>
        <translation>正在准备三维视图。</translation>
    </message>
</context>
<context>
    <name>SceneWindow</name>
    <message>
        <source>A window of its own needs OpenGL, which the screen “{platform}” does not offer.</source>
        <translation>独立窗口需要 OpenGL，而屏幕“{platform}”不提供。</translation>
    </message>
    <message>
        <source>The screen gives it no OpenGL.</source>
        <translation>屏幕没有为它提供 OpenGL。</translation>
    </message>
    <message>
        <source>3D view – beltcal</source>
        <translation>三维视图 – beltcal</translation>
    </message>
    <message>
        <source>3D view in a window of its own</source>
        <translation>独立窗口中的三维视图</translation>
    </message>
    <message>
        <source>This window cannot be drawn: {reason}</source>
        <translation>无法绘制此窗口：{reason}</translation>
    </message>
</context>
<context>
    <name>SidePanel</name>
    <message>
        <source>What to do and how good it is</source>
        <translation>做什么以及结果如何</translation>
    </message>
    <message>
        <source>Solve a&amp;gain</source>
        <translation>重新求解(&amp;G)</translation>
    </message>
    <message>
        <source>Solve from the samples that are ticked</source>
        <translation>用勾选的样本求解</translation>
    </message>
    <message>
        <source>S&amp;tart over</source>
        <translation>重新开始(&amp;T)</translation>
    </message>
    <message>
        <source>Delete all samples of this step; undo brings them back</source>
        <translation>删除此步骤的所有样本；可撤销恢复</translation>
    </message>
    <message>
        <source>The next thing to do (Ctrl+Return)</source>
        <translation>下一步要做的事（Ctrl+Return）</translation>
    </message>
</context>
<context>
    <name>StartPage</name>
    <message>
        <source>Enter your name: it is kept with every decision.</source>
        <translation>请输入您的姓名：它会与每个决定一起保存。</translation>
    </message>
    <message>
        <source>The serial number does not belong to this blade type; expected for instance {example}.</source>
        <translation>序列号不属于此叶片型号；正确形式例如 {example}。</translation>
    </message>
    <message>
        <source>Choose a folder for the session.</source>
        <translation>请选择会话的文件夹。</translation>
    </message>
    <message>
        <source>This folder holds a session already. Open that one, or choose another folder.</source>
        <translation>此文件夹中已有会话。请打开它，或选择其他文件夹。</translation>
    </message>
    <message>
        <source>Commission a belt grinding cell</source>
        <translation>调试砂带磨削单元</translation>
    </message>
    <message>
        <source>Six steps bring the cell up so that it grinds a turbine blade where the CAD model says. Each step is measured, solved, checked on data it has not seen, and accepted by you.</source>
        <translation>六个步骤使单元按 CAD 模型的要求磨削涡轮叶片。每一步都经过测量、求解、用未使用过的数据检验，并由您接受。</translation>
    </message>
    <message>
        <source>Your &amp;name</source>
        <translation>您的姓名(&amp;N)</translation>
    </message>
    <message>
        <source>Blade type</source>
        <translation>叶片型号</translation>
    </message>
    <message>
        <source>Serial n&amp;umber</source>
        <translation>序列号(&amp;U)</translation>
    </message>
    <message>
        <source>&amp;Folder</source>
        <translation>文件夹(&amp;F)</translation>
    </message>
    <message>
        <source>Choose…</source>
        <translation>选择…</translation>
    </message>
    <message>
        <source>Choose the session&apos;s folder</source>
        <translation>选择会话的文件夹</translation>
    </message>
    <message>
        <source>&amp;Begin on the simulated cell</source>
        <translation>在模拟单元上开始(&amp;B)</translation>
    </message>
    <message>
        <source>Begin and take the &amp;tour (2 minutes)</source>
        <translation>开始并观看导览（2 分钟）(&amp;T)</translation>
    </message>
    <message>
        <source>&amp;Open a session…</source>
        <translation>打开会话(&amp;O)…</translation>
    </message>
    <message>
        <source>Bac&amp;k to the open session</source>
        <translation>返回打开的会话(&amp;K)</translation>
    </message>
    <message>
        <source>Recent sessions</source>
        <translation>最近的会话</translation>
    </message>
    <message>
        <source>The six steps</source>
        <translation>六个步骤</translation>
    </message>
    <message>
        <source>The simulated cell is computed: no real device moves. Everything is kept on disk as it is taken; you may close the window or lose power at any time. This program is not a safety function.</source>
        <translation>模拟单元是计算出来的：没有真实设备移动。所有内容采集后立即存盘；您可以随时关闭窗口，断电也无妨。本程序不是安全功能。</translation>
    </message>
    <message>
        <source>where the scanner sits on its stage</source>
        <translation>扫描仪在位移台上的位置</translation>
    </message>
    <message>
        <source>where the scanner&apos;s stage stands to the robot</source>
        <translation>扫描仪的位移台相对机器人的位置</translation>
    </message>
    <message>
        <source>where the blade is clamped, roughly</source>
        <translation>叶片的装夹位置（粗略）</translation>
    </message>
    <message>
        <source>where the blade is, exactly</source>
        <translation>叶片的位置（精确）</translation>
    </message>
    <message>
        <source>where the contact wheels are</source>
        <translation>接触轮的位置</translation>
    </message>
    <message>
        <source>what is left, by touching, and the corrected programs</source>
        <translation>通过触碰得到剩余误差，以及修正后的程序</translation>
    </message>
    <message>
        <source>Opening…</source>
        <translation>正在打开…</translation>
    </message>
    <message>
        <source>Blade type {name}</source>
        <translation>叶片型号 {name}</translation>
    </message>
    <message>
        <source>Folder for the session</source>
        <translation>会话的文件夹</translation>
    </message>
</context>
<context>
    <name>StepEntry</name>
    <message>
        <source>ready to accept</source>
        <translation>可以接受</translation>
    </message>
</context>
<context>
    <name>StepPage</name>
    <message>
        <source>Samples</source>
        <translation>样本</translation>
    </message>
</context>
<context>
    <name>StepRail</name>
    <message>
        <source>Steps</source>
        <translation>步骤</translation>
    </message>
</context>
<context>
    <name>StepTexts</name>
    <message>
        <source>Where the scanner sits on its stage, and how the stage&apos;s axes run.</source>
        <translation>扫描仪在位移台上的位置，以及位移台各轴的走向。</translation>
    </message>
    <message>
        <source>Mount the ball. The stage moves the scanner about it; the robot brings the ball into view and then stands still.</source>
        <translation>请安装标准球。位移台带动扫描仪绕其移动；机器人将标准球送入视野后静止不动。</translation>
    </message>
    <message>
        <source>Mount and scan</source>
        <translation>安装并扫描</translation>
    </message>
    <message>
        <source>Where the measurement frame {M} lies in the robot&apos;s base {B}.</source>
        <translation>测量坐标系 {M} 在机器人基座 {B} 中的位置。</translation>
    </message>
    <message>
        <source>Leave the ball mounted. The robot shows it to the scanner in many poses; each motion is shown first.</source>
        <translation>保持标准球已安装。机器人以多个位姿将其展示给扫描仪；每次移动都会先显示。</translation>
    </message>
    <message>
        <source>Roughly where the blade is clamped, so that the fine step can begin.</source>
        <translation>叶片的大致装夹位置，以便精定位步骤开始。</translation>
    </message>
    <message>
        <source>Clamp the blade. It is found in its scan automatically, or by pairs of points that you pick.</source>
        <translation>请装夹叶片。在其扫描中自动查找它，或由您选取点对查找。</translation>
    </message>
    <message>
        <source>Clamp and scan</source>
        <translation>装夹并扫描</translation>
    </message>
    <message>
        <source>Exactly where the blade is, from the faces of its CAD model.</source>
        <translation>根据 CAD 模型的面得到叶片的精确位置。</translation>
    </message>
    <message>
        <source>Leave the blade clamped. The faces chosen below are scanned from several poses.</source>
        <translation>保持叶片装夹。下面选择的面将从多个位姿扫描。</translation>
    </message>
    <message>
        <source>Scan the faces</source>
        <translation>扫描各面</translation>
    </message>
    <message>
        <source>Where the stylus tip is, and with it the wheel of each grinder.</source>
        <translation>测针针尖的位置，以及由此得到的每台砂带磨床的接触轮位置。</translation>
    </message>
    <message>
        <source>Mount the stylus. Guide it by hand: first into the cone, then to the wheel shaft of each grinder.</source>
        <translation>请安装测针。用手引导它：先到锥窝，再到每台砂带磨床的轮轴。</translation>
    </message>
    <message>
        <source>Mount and touch</source>
        <translation>安装并触测</translation>
    </message>
    <message>
        <source>What error is left at the contact, and the paths that take it out.</source>
        <translation>接触处的剩余误差，以及消除它的路径。</translation>
    </message>
    <message>
        <source>Clamp the blade. It is brought to the wheel point by point; the contact force says how far off the path is.</source>
        <translation>请装夹叶片。它被逐点送到接触轮处；接触力说明路径偏离多少。</translation>
    </message>
    <message>
        <source>Clamp and probe</source>
        <translation>装夹并探测</translation>
    </message>
</context>
<context>
    <name>SuggestedPanel</name>
    <message>
        <source>Add the suggested sample to the plan</source>
        <translation>将建议的样本加入计划</translation>
    </message>
    <message>
        <source>It is then taken with the others that are missing</source>
        <translation>它将与其他缺少的样本一起采集</translation>
    </message>
</context>
<context>
    <name>SuggestionBox</name>
    <message>
        <source>Would improve: {what}</source>
        <translation>将改进：{what}</translation>
    </message>
    <message>
        <source>➜ Suggested next</source>
        <translation>➜ 建议下一步</translation>
    </message>
</context>
<context>
    <name>ToolPanel</name>
    <message>
        <source>Grinder {grinder}: {done} of {planned} touches</source>
        <translation>{grinder}砂带磨床：已触测 {done}/{planned}</translation>
    </message>
    <message>
        <source>Cone: {done} of {planned} touches</source>
        <translation>锥窝：{done}/{planned} 次触测</translation>
    </message>
    <message>
        <source>, head&apos;s stop not read yet</source>
        <translation>，浮动头止挡处尚未读数</translation>
    </message>
</context>
<context>
    <name>TopBar</name>
    <message>
        <source>No session is open</source>
        <translation>没有打开会话</translation>
    </message>
    <message>
        <source>Cancel</source>
        <translation>取消</translation>
    </message>
    <message>
        <source>Cancelling…</source>
        <translation>正在取消…</translation>
    </message>
    <message>
        <source>Ends the work at the next sample. What has been taken is kept.</source>
        <translation>在下一个样本处结束工作。已采集的内容保留。</translation>
    </message>
    <message>
        <source>Cancel the work</source>
        <translation>取消工作</translation>
    </message>
    <message>
        <source>Progress of the work</source>
        <translation>工作进度</translation>
    </message>
    <message>
        <source>Help of this step (F1)</source>
        <translation>此步骤的帮助（F1）</translation>
    </message>
    <message>
        <source>Help of this step</source>
        <translation>此步骤的帮助</translation>
    </message>
    <message>
        <source>STOP</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops every motion at once (Esc or F12). Not a safety function: use the emergency stop in danger.</source>
        <translation>立即停止所有移动（Esc 或 F12）。不是安全功能：遇险请使用急停。</translation>
    </message>
    <message>
        <source>Stop every motion at once</source>
        <translation>立即停止所有移动</translation>
    </message>
</context>
<context>
    <name>Tour</name>
    <message>
        <source>Six steps</source>
        <translation>六个步骤</translation>
    </message>
    <message>
        <source>From top to bottom. Each says in a word and a sign how it stands. Click one, or press Ctrl+1 to Ctrl+6, to look at it; looking changes nothing.</source>
        <translation>从上到下。每一步都用文字和符号表示其状态。点击其中一步，或按 Ctrl+1 到 Ctrl+6 查看；查看不会改变任何内容。</translation>
    </message>
    <message>
        <source>What to do</source>
        <translation>要做什么</translation>
    </message>
    <message>
        <source>Here you read what to mount, what the result is and how good it is. Every number has its unit and its uncertainty.</source>
        <translation>这里说明要安装什么、结果是什么以及好坏程度。每个数值都有单位和不确定度。</translation>
    </message>
    <message>
        <source>The next thing to do</source>
        <translation>下一步要做的事</translation>
    </message>
    <message>
        <source>There is one large coloured button. It takes the samples, then accepts the result. When in doubt, this is the one to press.</source>
        <translation>有一个大的彩色按钮。它采集样本，然后接受结果。拿不准时，按它就对了。</translation>
    </message>
    <message>
        <source>You decide about every motion</source>
        <translation>每次移动都由您决定</translation>
    </message>
    <message>
        <source>Before the robot moves, its path is drawn and you are asked here: confirm it, or hold the button down and the robot moves only as long as you hold.</source>
        <translation>机器人移动之前会画出路径，并在这里询问您：确认，或按住按钮，只有按住时机器人才移动。</translation>
    </message>
    <message>
        <source>Stop</source>
        <translation>停止</translation>
    </message>
    <message>
        <source>Stops every motion at once, always: by this button, by Esc or by F12. In danger use the cell&apos;s emergency stop; this program is not a safety function.</source>
        <translation>随时立即停止所有移动：用此按钮、Esc 或 F12。遇险请使用单元的急停；本程序不是安全功能。</translation>
    </message>
    <message>
        <source>The picture</source>
        <translation>画面</translation>
    </message>
    <message>
        <source>What was measured, on what is expected. Turn it with the left button, zoom with the wheel.</source>
        <translation>测得的内容叠加在预期的内容上。用左键转动，用滚轮缩放。</translation>
    </message>
    <message>
        <source>The samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>Each with its residual. Untick one and the step is solved again at once; nothing is lost, undo brings it back.</source>
        <translation>每个样本都有残差。取消勾选一个，步骤会立即重新求解；不会丢失任何内容，可撤销恢复。</translation>
    </message>
    <message>
        <source>The verdict</source>
        <translation>判定</translation>
    </message>
    <message>
        <source>Accepted or rejected, why, and what to do about it. It rests on data that the fit has not seen, never on small residuals alone.</source>
        <translation>接受或拒绝、原因以及处理办法。它依据拟合未使用的数据，绝不只依据小残差。</translation>
    </message>
    <message>
        <source>The devices</source>
        <translation>设备</translation>
    </message>
    <message>
        <source>Each device says how it is and since when. On the simulated cell nothing real moves.</source>
        <translation>每台设备显示其状态及起始时间。在模拟单元上没有真实设备移动。</translation>
    </message>
    <message>
        <source>Help</source>
        <translation>帮助</translation>
    </message>
    <message>
        <source>F1 explains the step you look at: what to mount, what to watch, what a rejection means. This tour is in the Help menu.</source>
        <translation>F1 说明您正在查看的步骤：要安装什么、注意什么、拒绝意味着什么。此导览在“帮助”菜单中。</translation>
    </message>
</context>
<context>
    <name>Verdict</name>
    <message>
        <source>The session is being restored.</source>
        <translation>正在恢复会话。</translation>
    </message>
    <message>
        <source>Stale because:</source>
        <translation>失效原因：</translation>
    </message>
    <message>
        <source>so far good</source>
        <translation>目前良好</translation>
    </message>
    <message>
        <source>so far not good enough</source>
        <translation>目前还不够好</translation>
    </message>
    <message>
        <source>More samples are needed.</source>
        <translation>需要更多样本。</translation>
    </message>
</context>
<context>
    <name>Words</name>
    <message>
        <source>fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>check</source>
        <translation>检验</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>▲ worst</source>
        <translation>▲ 最差</translation>
    </message>
    <message>
        <source>✖ outlier</source>
        <translation>✖ 离群</translation>
    </message>
    <message>
        <source>✖ refused</source>
        <translation>✖ 拒收</translation>
    </message>
    <message>
        <source>✖ rejected</source>
        <translation>✖ 已剔除</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>标准球</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>Rough workpiece</source>
        <translation>工件粗定位</translation>
    </message>
    <message>
        <source>Fine workpiece</source>
        <translation>工件精定位</translation>
    </message>
    <message>
        <source>Stylus and tool</source>
        <translation>测针与工具</translation>
    </message>
    <message>
        <source>Error surface</source>
        <translation>误差曲面</translation>
    </message>
</context>
<context>
    <name>sentence</name>
    <message>
        <source>(none)</source>
        <translation>（无）</translation>
    </message>
    <message>
        <source>(ratio)</source>
        <translation>（比值）</translation>
    </message>
    <message>
        <source>({0} bytes where {1} are expected)</source>
        <translation>（{0}字节，应为{1}字节）</translation>
    </message>
    <message>
        <source>({0} observations, repeats count once)</source>
        <translation>（{0}个观测，重复的只计一次）</translation>
    </message>
    <message>
        <source>1 sample</source>
        <translation>1 个样本</translation>
    </message>
    <message>
        <source>3 pairs fix the pose but leave no pair over to check it: a bad pick shows only in the distances between the picks. Pick 5 or more pairs.</source>
        <translation>3 个点对可以确定位姿，但没有多余的点对用来检验：选错的点只能从点间距离看出。请选取 5 个或更多点对。</translation>
    </message>
    <message>
        <source>A pose was found that puts {0} of the scan on {1}, but the fine step refuses it: {2}</source>
        <translation>找到了一个位姿，使扫描的{0}落在{1}上，但精定位步骤拒绝它：{2}</translation>
    </message>
    <message>
        <source>A waiting time must be zero or more seconds, found {0}.</source>
        <translation>等待时间必须为零秒或更长，现为{0}。</translation>
    </message>
    <message>
        <source>Acquire goes on with it; what is there is not taken again.</source>
        <translation>“采集”会由此继续；已有的不会重复采集。</translation>
    </message>
    <message>
        <source>Add a face whose normal points along ({0}, {1}, {2}), even partly.</source>
        <translation>请增加一个法线至少部分沿 ({0}, {1}, {2}) 方向的面。</translation>
    </message>
    <message>
        <source>Add a plane beside the line through the middle of the faces along ({0}, {1}, {2}), its normal crosswise to that line.</source>
        <translation>请在沿 ({0}, {1}, {2}) 穿过各面中部的直线旁边增加一个平面，其法线与该直线交叉。</translation>
    </message>
    <message>
        <source>Add scans of the ball at positions that differ more.</source>
        <translation>请在差别更大的位置增加对标准球的扫描。</translation>
    </message>
    <message>
        <source>Add touches, one of them near head angle 0, over a longer arc.</source>
        <translation>请增加触测，其中一次接近浮动头角度 0，并覆盖更长的弧段。</translation>
    </message>
    <message>
        <source>All head angles are the same ({0} deg) although the touches differ by up to {1} mm. Check that the angle sensor is read at every touch.</source>
        <translation>所有浮动头角度都相同（{0} deg），而各触测点相差达{1} mm。请检查每次触测时是否读取了角度传感器。</translation>
    </message>
    <message>
        <source>All picks lie within {0} mm, on the scan and on the CAD model. They look like metres; give both in mm.</source>
        <translation>所有选点都在{0} mm 范围内，扫描和 CAD 模型上均如此。看起来单位是米；两者都请用 mm 给出。</translation>
    </message>
    <message>
        <source>All samples &apos;{0}&apos; of the step &apos;{1}&apos; are left out. Tick at least some of them.</source>
        <translation>步骤“{1}”的样本“{0}”全部被排除。请至少勾选其中一部分。</translation>
    </message>
    <message>
        <source>All {0} observations are at the same flange pose: the robot has not moved. Move the ball to at least 4 different places, two of them tilted.</source>
        <translation>全部{0}个观测的法兰位姿相同：机器人没有移动。请将标准球移到至少 4 个不同位置，其中两个要倾斜。</translation>
    </message>
    <message>
        <source>All {0} touches are at the same flange pose. Keep the tip in the cone and tilt the flange by 20 deg or more about different axes.</source>
        <translation>全部{0}次触测的法兰位姿相同。请让针尖保持在锥窝内，绕不同的轴将法兰倾斜 20 deg 或更多。</translation>
    </message>
    <message>
        <source>All {0} touches are at the same place (within {1} mm): the head has not turned. Turn it as far as it goes between touches.</source>
        <translation>全部{0}次触测都在同一位置（{1} mm 以内）：浮动头没有转动。请在两次触测之间把它转到最大行程。</translation>
    </message>
    <message>
        <source>An average needs at least two error surfaces, found {0}.</source>
        <translation>取平均至少需要两个误差曲面，现有{0}个。</translation>
    </message>
    <message>
        <source>Ball diameter: expected a positive number of mm, found {0}.</source>
        <translation>标准球直径：应为正数（mm），现为{0}。</translation>
    </message>
    <message>
        <source>CAD model</source>
        <translation>CAD 模型</translation>
    </message>
    <message>
        <source>Check that the ball did not move and repeat the worst observation.</source>
        <translation>请检查标准球是否没有移动，并重做最差的那次观测。</translation>
    </message>
    <message>
        <source>Check the angle sensor and that it is read at the moment of the touch.</source>
        <translation>请检查角度传感器，并确认在触测的瞬间读取它。</translation>
    </message>
    <message>
        <source>Check the angle sensor&apos;s coupling and the stop, then calibrate the tool again.</source>
        <translation>请检查角度传感器的联轴器和挡块，然后重新标定工具。</translation>
    </message>
    <message>
        <source>Check the certified diameter and the scanner&apos;s scale.</source>
        <translation>请检查证书直径和扫描仪的比例系数。</translation>
    </message>
    <message>
        <source>Check the link to the angle sensor and measure again.</source>
        <translation>请检查与角度传感器的连接，然后重新测量。</translation>
    </message>
    <message>
        <source>Check the mounting of the axes and that their order and signs are right.</source>
        <translation>请检查各轴的安装，以及轴的顺序和符号是否正确。</translation>
    </message>
    <message>
        <source>Check the scanner&apos;s exposure and that nothing moved during the scan.</source>
        <translation>请检查扫描仪的曝光，并确认扫描期间没有任何移动。</translation>
    </message>
    <message>
        <source>Check the unit and pitch of the axis and the scanner&apos;s scale.</source>
        <translation>请检查该轴的单位和螺距，以及扫描仪的比例系数。</translation>
    </message>
    <message>
        <source>Clean the ball, scan it closer and from a side on which nothing hides it.</source>
        <translation>请清洁标准球，靠近一些，从没有遮挡的一侧扫描。</translation>
    </message>
    <message>
        <source>Covariance of the error surface: the noise is unknown or a point was not measured.</source>
        <translation>误差曲面的协方差：噪声未知，或有一个点没有测量。</translation>
    </message>
    <message>
        <source>Does the head bounce? Measure slower or press harder.</source>
        <translation>浮动头是否跳动？请放慢测量或压得更紧。</translation>
    </message>
    <message>
        <source>Error surface: a control point is not a number.</source>
        <translation>误差曲面：有一个控制点不是数字。</translation>
    </message>
    <message>
        <source>Error surface: a field cannot be read ({0}).</source>
        <translation>误差曲面：有一个字段无法读取（{0}）。</translation>
    </message>
    <message>
        <source>Error surface: degrees {0}, expected {1}.</source>
        <translation>误差曲面：次数为{0}，应为{1}。</translation>
    </message>
    <message>
        <source>Error surface: fewer than four samples are marked as used.</source>
        <translation>误差曲面：标记为已使用的样本少于四个。</translation>
    </message>
    <message>
        <source>Error surface: info is {0}, expected an object. Write the file again.</source>
        <translation>误差曲面：info 为{0}，应为一个对象。请重新写出文件。</translation>
    </message>
    <message>
        <source>Error surface: its control points do not give its own sample at u {0}, v {1} (off by {2} mm). The file was changed: write it again.</source>
        <translation>误差曲面：其控制点给不出它自己在 u {0}、v {1}处的样本（相差{2} mm）。文件被改动过：请重新写出。</translation>
    </message>
    <message>
        <source>Error surface: reach_steps is {0}, expected a number above 0.</source>
        <translation>误差曲面：reach_steps 为{0}，应为大于 0 的数。</translation>
    </message>
    <message>
        <source>Error surface: the field {0} is missing. Write the file again.</source>
        <translation>误差曲面：缺少字段{0}。请重新写出文件。</translation>
    </message>
    <message>
        <source>Error surface: the knots must be finite and must not fall.</source>
        <translation>误差曲面：节点必须是有限数且不得递减。</translation>
    </message>
    <message>
        <source>Error surface: the sample columns differ in length.</source>
        <translation>误差曲面：各样本列的长度不同。</translation>
    </message>
    <message>
        <source>Error surface: {0} control points, the knots ask for {1}.</source>
        <translation>误差曲面：有{0}个控制点，而节点要求{1}个。</translation>
    </message>
    <message>
        <source>Faces with fewer than {0} points: {1}. Scan them from another side, or take them off the list.</source>
        <translation>点数少于{0}的面：{1}。请从另一侧扫描它们，或将它们从列表中去掉。</translation>
    </message>
    <message>
        <source>Found {0} different flange poses, at least {1} are needed, 6 or more are better. Keep the tip in the cone and tilt the flange further.</source>
        <translation>找到{0}个不同的法兰位姿，至少需要{1}个，6 个或更多更好。请让针尖保持在锥窝内，并加大法兰的倾斜。</translation>
    </message>
    <message>
        <source>Found {0} different flange poses{1}, at least {2} are needed, 6 or more are better. Add poses with the flange tilted by 5 deg or more.</source>
        <translation>找到{0}个不同的法兰位姿{1}，至少需要{2}个，6 个或更多更好。请增加法兰倾斜 5 deg 或更多的位姿。</translation>
    </message>
    <message>
        <source>Found {0} pairs; a pose needs at least 3 that don&apos;t lie on a line. Pick 5 or more.</source>
        <translation>找到{0}个点对；确定位姿至少需要 3 个不共线的点对。请选取 5 个或更多。</translation>
    </message>
    <message>
        <source>Found {0} touches at different places, at least {1} are needed, 5 or more are better. Touch the shaft at more head angles.</source>
        <translation>找到{0}个不同位置的触测，至少需要{1}个，5 个或更多更好。请在更多浮动头角度下触测轮轴。</translation>
    </message>
    <message>
        <source>Give exactly one of count, spacing_mm and positions, found {0}.</source>
        <translation>count、spacing_mm 和 positions 必须且只能给出一个，现有{0}。</translation>
    </message>
    <message>
        <source>Give the known radius or turn the head farther.</source>
        <translation>请给出已知半径，或把浮动头转得更大。</translation>
    </message>
    <message>
        <source>Grinder {0}: {1}</source>
        <translation>{0}砂带磨床：{1}</translation>
    </message>
    <message>
        <source>Is {0} meant?</source>
        <translation>是否指{0}？</translation>
    </message>
    <message>
        <source>It has slipped in its clamp, or robot or stage have moved: fasten it and begin again with the rough step.</source>
        <translation>叶片在夹具中滑动，或者机器人或位移台移动了：请紧固，并从粗定位步骤重新开始。</translation>
    </message>
    <message>
        <source>It looks like metres.</source>
        <translation>看起来单位是米。</translation>
    </message>
    <message>
        <source>It looks transposed.</source>
        <translation>看起来被转置了。</translation>
    </message>
    <message>
        <source>Least certain: {0}. Spread the picks wider or add pairs.</source>
        <translation>最不确定的是：{0}。请把选点分布得更开，或增加点对。</translation>
    </message>
    <message>
        <source>Look at {0} first.</source>
        <translation>请先查看{0}。</translation>
    </message>
    <message>
        <source>Look at {0} first; repeat it or add poses.</source>
        <translation>请先查看{0}；重做它或增加位姿。</translation>
    </message>
    <message>
        <source>Look for something that touches the ball, dirt or edge ghosts on one side.</source>
        <translation>请查找接触标准球的物体、污物或一侧的边缘虚点。</translation>
    </message>
    <message>
        <source>Measure a denser grid, or look for what makes the head&apos;s angle noisy.</source>
        <translation>请测量更密的网格，或查明浮动头角度噪声的来源。</translation>
    </message>
    <message>
        <source>Measure again there or use smoothing (--smooth), which bridges small gaps and drops bad samples.</source>
        <translation>请在该处重新测量，或使用平滑（--smooth），它可以跨越小空缺并剔除坏样本。</translation>
    </message>
    <message>
        <source>Measure slower and check the head&apos;s angle sensor.</source>
        <translation>请放慢测量，并检查浮动头的角度传感器。</translation>
    </message>
    <message>
        <source>Mount the {0}{1} on the flange, then confirm.</source>
        <translation>请将{0}{1}安装到法兰上，然后确认。</translation>
    </message>
    <message>
        <source>No arc would do with this noise: touch more carefully.</source>
        <translation>在这样的噪声下，任何弧段都不够：请更仔细地触测。</translation>
    </message>
    <message>
        <source>No ball of diameter {0} mm was found in the scan</source>
        <translation>扫描中没有找到直径{0} mm 的标准球</translation>
    </message>
    <message>
        <source>No ball of {0} to {1} mm diameter was found in the scan (planes, cylinders and scattered points do not count, nor a cap too flat to tell from a plane). Aim at the ball, or give its certified diameter with --diameter and --fix-diameter.</source>
        <translation>扫描中没有找到直径{0}到{1} mm 的球（平面、圆柱和散乱点不算，平到无法与平面区分的球冠也不算）。请对准标准球，或用 --diameter 和 --fix-diameter 给出其证书直径。</translation>
    </message>
    <message>
        <source>No line of the airfoil has been probed on grinder {0}. Probe it first.</source>
        <translation>在{0}砂带磨床上还没有探测过叶身的任何一条线。请先探测。</translation>
    </message>
    <message>
        <source>No observation was kept out of the fit, so nothing shows how well it predicts. {0}</source>
        <translation>没有任何观测留在拟合之外，因此无法说明其预测能力。{0}</translation>
    </message>
    <message>
        <source>No scan shows the ball yet. Take the scans.</source>
        <translation>还没有任何扫描显示标准球。请采集扫描。</translation>
    </message>
    <message>
        <source>No single pick explains it; the largest distance is at &apos;{0}&apos;. Check that all pairs are the same features on the same blade type and pick again.</source>
        <translation>没有哪个单独的选点能解释它；距离最大的是“{0}”。请检查所有点对是否为同一叶片型号上的相同特征，然后重新选取。</translation>
    </message>
    <message>
        <source>No two flat areas of the scan meet at an angle that flat areas of the CAD model have. Check the blade type.</source>
        <translation>扫描中没有任何两个平面区域的夹角与 CAD 模型的平面区域相符。请检查叶片型号。</translation>
    </message>
    <message>
        <source>None of the {0} faces can be used for registration; each says why. Export the solid with exact faces.</source>
        <translation>{0}个面中没有一个可用于配准；每个面都说明了原因。请以精确曲面导出实体。</translation>
    </message>
    <message>
        <source>Not enough points on chosen faces ({0}). Scan these faces too, or leave them out of the list.</source>
        <translation>所选面上的点不足（{0}）。请也扫描这些面，或将它们从列表中去掉。</translation>
    </message>
    <message>
        <source>OCP.STEPControl</source>
        <translation>OCP.STEPControl</translation>
    </message>
    <message>
        <source>Only {0} % of the ball&apos;s surface was seen, {1} % are asked. Turn the ball&apos;s free side to the scanner.</source>
        <translation>只看到标准球表面的{0} %，要求{1} %。请把标准球无遮挡的一侧转向扫描仪。</translation>
    </message>
    <message>
        <source>Only {0} % of the points lie on the ball, {1} % are asked. Cut away the surroundings or scan the ball closer.</source>
        <translation>只有{0} % 的点位于标准球上，要求{1} %。请切除周围部分，或靠近扫描标准球。</translation>
    </message>
    <message>
        <source>Only {0} faces have points, at least {1} are needed. Scan more faces of the blade.</source>
        <translation>只有{0}个面有点，至少需要{1}个。请扫描叶片的更多面。</translation>
    </message>
    <message>
        <source>Only {0} new samples lie where the old error surface was measured, {1} are needed to tell whether it still fits.</source>
        <translation>只有{0}个新样本位于旧误差曲面的测量范围内，需要{1}个才能判断它是否仍然适用。</translation>
    </message>
    <message>
        <source>Only {0} of the points near the faces lie on them, at least {1} are expected. Look for dirt, clamps close to the faces, or another blade type.</source>
        <translation>各面附近的点中只有{0}落在面上，至少应为{1}。请检查是否有污物、靠近各面的夹具，或是另一种叶片型号。</translation>
    </message>
    <message>
        <source>Only {0} places of the scan are flat enough to tell a direction, at least 100 are needed. Scan edge plate and shroud with more points.</source>
        <translation>扫描中只有{0}处足够平，可以判断方向，至少需要 100 处。请用更多的点扫描缘板和叶冠。</translation>
    </message>
    <message>
        <source>Only {0} points lie on the ball, {1} are asked. Scan it closer.</source>
        <translation>只有{0}个点位于标准球上，要求{1}个。请靠近扫描。</translation>
    </message>
    <message>
        <source>Only {0} scan points lie on the chosen faces, at least {1} are needed. Scan more of the blade, or check that start and STEP file belong to this scan.</source>
        <translation>只有{0}个扫描点位于所选面上，至少需要{1}个。请扫描叶片的更多部分，或检查初值和 STEP 文件是否属于该扫描。</translation>
    </message>
    <message>
        <source>PCD ascii</source>
        <translation>PCD ASCII</translation>
    </message>
    <message>
        <source>PCD binary</source>
        <translation>PCD 二进制</translation>
    </message>
    <message>
        <source>PCD binary compressed</source>
        <translation>PCD 二进制压缩</translation>
    </message>
    <message>
        <source>PLY ascii</source>
        <translation>PLY ASCII</translation>
    </message>
    <message>
        <source>PLY binary big-endian</source>
        <translation>PLY 二进制大端</translation>
    </message>
    <message>
        <source>PLY binary little-endian</source>
        <translation>PLY 二进制小端</translation>
    </message>
    <message>
        <source>Pair &apos;{0}&apos; is {1} mm off where the other pairs agree within {2} mm: pick it again.</source>
        <translation>点对“{0}”偏差{1} mm，而其他点对在{2} mm 以内一致：请重新选取它。</translation>
    </message>
    <message>
        <source>Pairs &apos;{0}&apos; and &apos;{1}&apos; are the same pick entered twice. Remove one of them.</source>
        <translation>点对“{0}”和“{1}”是同一选点输入了两次。请去掉其中一个。</translation>
    </message>
    <message>
        <source>Pick it again.</source>
        <translation>请重新选取。</translation>
    </message>
    <message>
        <source>Pick more carefully or add pairs.</source>
        <translation>请更仔细地选取，或增加点对。</translation>
    </message>
    <message>
        <source>Pose {0} of {1}: flange {2} = {3} mm is {4} the workspace limit {5} mm. Change the pattern or where the blade is presented.</source>
        <translation>位姿{0}/{1}：法兰{2} = {3} mm，{4}工作空间限值{5} mm。请更改走刀方式或叶片的送检位置。</translation>
    </message>
    <message>
        <source>Pose {0} of {1}: the flange is {2} mm from the base, the reach is {3} mm.</source>
        <translation>位姿{0}/{1}：法兰距基座{2} mm，可达范围为{3} mm。</translation>
    </message>
    <message>
        <source>Probe a finer grid, and see that the head moves freely.</source>
        <translation>请探测更密的网格，并确认浮动头活动自如。</translation>
    </message>
    <message>
        <source>RMS distance of the pairs</source>
        <translation>点对距离 RMS</translation>
    </message>
    <message>
        <source>RMS error of the predicted {0}</source>
        <translation>{0}预测误差 RMS</translation>
    </message>
    <message>
        <source>RMS on the faces {0} µm, {1} points</source>
        <translation>面上 RMS {0} µm，{1}个点</translation>
    </message>
    <message>
        <source>Registration measures on planes and cylinders; this face is a cone.</source>
        <translation>配准在平面和圆柱面上测量；该面是圆锥面。</translation>
    </message>
    <message>
        <source>Registration measures on planes and cylinders; this face is a free-form (B-spline) surface.</source>
        <translation>配准在平面和圆柱面上测量；该面是自由曲面（B 样条）。</translation>
    </message>
    <message>
        <source>Registration measures on planes and cylinders; this face is a sphere.</source>
        <translation>配准在平面和圆柱面上测量；该面是球面。</translation>
    </message>
    <message>
        <source>Registration measures on planes and cylinders; this face is a swept or offset surface.</source>
        <translation>配准在平面和圆柱面上测量；该面是扫掠面或偏置面。</translation>
    </message>
    <message>
        <source>Registration measures on planes and cylinders; this face is a torus.</source>
        <translation>配准在平面和圆柱面上测量；该面是环面。</translation>
    </message>
    <message>
        <source>Repeat it or leave it out.</source>
        <translation>请重做，或将其排除。</translation>
    </message>
    <message>
        <source>Repeat the touches; check that the tip is in place.</source>
        <translation>请重做各次触测；检查针尖是否到位。</translation>
    </message>
    <message>
        <source>STL ascii</source>
        <translation>STL ASCII</translation>
    </message>
    <message>
        <source>STL binary</source>
        <translation>STL 二进制</translation>
    </message>
    <message>
        <source>Sample {0} was deleted. Undo the deletion first.</source>
        <translation>样本{0}已被删除。请先撤销删除。</translation>
    </message>
    <message>
        <source>Sample {0}: (u {1}, v {2}) is outside the airfoil&apos;s domain u {3} to {4}, v {5} to {6} ({7} such samples). Check that u and v are not swapped.</source>
        <translation>样本{0}：(u {1}, v {2}) 超出叶身参数域 u {3}到{4}、v {5}到{6}（这样的样本有{7}个）。请检查 u 和 v 是否互换。</translation>
    </message>
    <message>
        <source>Sample {0}: u, v or error_mm is not a number ({1} samples).</source>
        <translation>样本{0}：u、v 或 error_mm 不是数字（{1}个样本）。</translation>
    </message>
    <message>
        <source>Samples lie on {0} lines of u and {1} lines of v; a cubic surface needs at least 4 of each. Measure a wider grid.</source>
        <translation>样本位于{0}条 u 线和{1}条 v 线上；三次曲面各至少需要 4 条。请测量更宽的网格。</translation>
    </message>
    <message>
        <source>Scan &apos;{0}&apos;: {1}</source>
        <translation>扫描“{0}”：{1}</translation>
    </message>
    <message>
        <source>Scan &apos;{0}&apos;: {1} Leave it out, or delete it and scan again.</source>
        <translation>扫描“{0}”：{1}请将其排除，或删除后重新扫描。</translation>
    </message>
    <message>
        <source>Scan again; did anything move?</source>
        <translation>请重新扫描；是否有东西移动了？</translation>
    </message>
    <message>
        <source>Scan more of the ball{0}.</source>
        <translation>请扫描标准球的更大部分{0}。</translation>
    </message>
    <message>
        <source>Scan of the ball: all points coincide. Check the scan file; one that holds a surface is needed.</source>
        <translation>标准球扫描：所有点重合。请检查扫描文件；需要包含表面的文件。</translation>
    </message>
    <message>
        <source>Scan of the ball: expected points as rows of three numbers.</source>
        <translation>标准球扫描：点应为每行三个数。</translation>
    </message>
    <message>
        <source>Scan of the ball: expected points of shape (N, 3), found {0}.</source>
        <translation>标准球扫描：点的形状应为 (N, 3)，现为{0}。</translation>
    </message>
    <message>
        <source>Scan of the ball: found {0} points, at least {1} are needed. Scan the ball again.</source>
        <translation>标准球扫描：找到{0}个点，至少需要{1}个。请重新扫描标准球。</translation>
    </message>
    <message>
        <source>Scan of the ball: the points lie in one plane, no ball can be found. Aim the scanner at the ball.</source>
        <translation>标准球扫描：点都在一个平面内，找不到球。请将扫描仪对准标准球。</translation>
    </message>
    <message>
        <source>Scan of the ball: the points lie on one line, no ball can be found. Scan an area of the ball.</source>
        <translation>标准球扫描：点都在一条直线上，找不到球。请扫描标准球的一块区域。</translation>
    </message>
    <message>
        <source>Scan of the ball: the whole cloud is only {0} wide where mm are expected. It looks like metres: multiply by 1000 or export in mm.</source>
        <translation>标准球扫描：整个点云只有{0}宽，而单位应为 mm。看起来单位是米：请乘以 1000 或以 mm 导出。</translation>
    </message>
    <message>
        <source>Scan of the ball: {0} of {1} points are NaN or infinite. Drop points without a measurement.</source>
        <translation>标准球扫描：{1}个点中有{0}个为 NaN 或无穷大。请去掉没有测量值的点。</translation>
    </message>
    <message>
        <source>Scanner noise: expected a positive sigma in mm, found {0}.</source>
        <translation>扫描仪噪声：应为正的 sigma（mm），现为{0}。</translation>
    </message>
    <message>
        <source>Scanner on its stage</source>
        <translation>位移台上的扫描仪</translation>
    </message>
    <message>
        <source>Scatter of the stage in it, each coordinate</source>
        <translation>其中位移台的离散度，每个坐标</translation>
    </message>
    <message>
        <source>Seen from the start, no scan points lie near the model, and the start&apos;s translation is only {0} mm long: it seems to be in metres. Give it in mm.</source>
        <translation>从初值看，模型附近没有扫描点，而初值的平移只有{0} mm 长：其单位似乎是米。请用 mm 给出。</translation>
    </message>
    <message>
        <source>Seen from the start, no scan points lie on the chosen faces: {0}. Check that scan, start and STEP file belong together, or redo the rough step.</source>
        <translation>从初值看，所选面上没有扫描点：{0}。请检查扫描、初值和 STEP 文件是否对应，或重做粗定位步骤。</translation>
    </message>
    <message>
        <source>Stage observation {0}: contains NaN or infinite numbers.</source>
        <translation>位移台观测{0}：含有 NaN 或无穷大。</translation>
    </message>
    <message>
        <source>Stage observation {0}: the rotary angle is {1} where rad are expected (more than two turns). It looks like degrees.</source>
        <translation>位移台观测{0}：旋转角为{1}，而单位应为 rad（超过两圈）。看起来单位是度。</translation>
    </message>
    <message>
        <source>Stage observations: expected one positive sigma in mm for each observation.</source>
        <translation>位移台观测：每个观测应有一个正的 sigma（mm）。</translation>
    </message>
    <message>
        <source>Stage observations: expected positions (N, 3), angles (N,) and balls (N, 3), found {0}, {1} and {2}.</source>
        <translation>位移台观测：应为位置 (N, 3)、角度 (N,) 和球心 (N, 3)，现为{0}、{1}和{2}。</translation>
    </message>
    <message>
        <source>Stage observations: the stage moved over {0} and the ball centres over {1}, both expected in mm and about equal. The {2} look like metres.</source>
        <translation>位移台观测：位移台移动范围为{0}，球心移动范围为{1}，两者单位都应为 mm 且大致相等。{2}看起来单位是米。</translation>
    </message>
    <message>
        <source>Stage observations: there are none.</source>
        <translation>位移台观测：没有任何观测。</translation>
    </message>
    <message>
        <source>Stage position: expected three finite numbers in mm and an angle in rad.</source>
        <translation>位移台位置：应为三个有限数（mm）和一个角度（rad）。</translation>
    </message>
    <message>
        <source>Stage: axis {0} was not moved, its direction is unknown. Add a scan of the ball with axis {1} moved.</source>
        <translation>位移台：轴{0}没有移动，其方向未知。请增加一次移动轴{1}后的标准球扫描。</translation>
    </message>
    <message>
        <source>Stage: found {0} ball observations, at least {1} are needed for the axes that were moved ({2}). Add positions.</source>
        <translation>位移台：找到{0}个标准球观测，移动过的轴（{2}）至少需要{1}个。请增加位置。</translation>
    </message>
    <message>
        <source>Stage: it stood still in all observations. Move axes x and y (and z) between the scans of the ball.</source>
        <translation>位移台：在所有观测中都静止不动。请在各次标准球扫描之间移动 x 轴和 y 轴（以及 z 轴）。</translation>
    </message>
    <message>
        <source>Stage: the axes {0} were only moved together (their positions lie on one line or plane), so that their directions cannot be told apart. Add positions where each moves alone.</source>
        <translation>位移台：轴{0}只是一起移动过（其位置在一条直线或一个平面上），因此无法区分它们的方向。请增加各轴单独移动的位置。</translation>
    </message>
    <message>
        <source>Stage: the positions do not determine the axes {0}.{1} Add positions.</source>
        <translation>位移台：这些位置不能确定轴{0}。{1}请增加位置。</translation>
    </message>
    <message>
        <source>Stylus in the cone</source>
        <translation>锥窝中的测针</translation>
    </message>
    <message>
        <source>Take everything off the flange.</source>
        <translation>请取下法兰上的所有物品。</translation>
    </message>
    <message>
        <source>The RMS distance of the points from the faces</source>
        <translation>点到各面距离的 RMS</translation>
    </message>
    <message>
        <source>The RMS held-out error</source>
        <translation>留出误差 RMS</translation>
    </message>
    <message>
        <source>The RMS of the angle residuals</source>
        <translation>角度残差 RMS</translation>
    </message>
    <message>
        <source>The RMS residual</source>
        <translation>残差 RMS</translation>
    </message>
    <message>
        <source>The airfoil has no tangent plane at a point of the path.</source>
        <translation>叶身在路径的某一点处没有切平面。</translation>
    </message>
    <message>
        <source>The airfoil&apos;s surface does not move along a line of the pattern.</source>
        <translation>叶身曲面沿走刀线没有变化。</translation>
    </message>
    <message>
        <source>The axes x, y, z form a left-handed set: one axis counts backwards, or two are exchanged. Check the signs and the order of stage_mm and of the ball centres.</source>
        <translation>轴 x、y、z 构成左手系：有一个轴计数方向相反，或有两个轴互换。请检查 stage_mm 和球心的符号与顺序。</translation>
    </message>
    <message>
        <source>The ball centres lie on one line, along {0} in the measuring frame: the rotation about that line is free. Add poses to the side of it.</source>
        <translation>各球心在测量坐标系中位于沿{0}的一条直线上：绕该直线的旋转没有约束。请在其侧面增加位姿。</translation>
    </message>
    <message>
        <source>The ball coordinates look mirrored (left-handed): with one axis reversed they fit. Check the signs of the scanner&apos;s and the stage&apos;s axes.</source>
        <translation>球坐标看起来是镜像的（左手系）：将一个轴反向后即可吻合。请检查扫描仪和位移台各轴的符号。</translation>
    </message>
    <message>
        <source>The ball hardly moved in the measuring frame ({0} mm in all): the rotation of that frame is free. Move the ball by 50 mm or more between poses.</source>
        <translation>标准球在测量坐标系中几乎没有移动（总共{0} mm）：该坐标系的旋转没有约束。请在各位姿之间将标准球移动 50 mm 或更多。</translation>
    </message>
    <message>
        <source>The ball may have moved on the flange, or the robot&apos;s mastering is off: check both.</source>
        <translation>标准球可能在法兰上移动了，或机器人零点不准：请两者都检查。</translation>
    </message>
    <message>
        <source>The ball or the scanner may have moved between the scans: fasten both, scan again.</source>
        <translation>标准球或扫描仪可能在两次扫描之间移动了：请将两者紧固，然后重新扫描。</translation>
    </message>
    <message>
        <source>The ball step has no result yet, so the scans cannot be placed. Finish the ball step first.</source>
        <translation>标准球步骤还没有结果，因此无法放置扫描。请先完成标准球步骤。</translation>
    </message>
    <message>
        <source>The ball, the stage or the robot has moved meanwhile: fasten everything and scan again.</source>
        <translation>标准球、位移台或机器人在此期间移动了：请全部紧固，然后重新扫描。</translation>
    </message>
    <message>
        <source>The base fit did not settle in {0} steps (last change {1} mm). Add poses tilted about other axes.</source>
        <translation>基坐标系拟合在{0}步内没有稳定（最后一次变化{1} mm）。请增加绕其他轴倾斜的位姿。</translation>
    </message>
    <message>
        <source>The blade as it is clamped for probing is not accepted: {0} Check the clamp and acquire again: the blade is clamped and scanned anew. The robot has not presented it to the wheel of grinder {1}.</source>
        <translation>叶片在探测时的装夹未被接受：{0}请检查夹具并重新采集：叶片将重新装夹并扫描。机器人没有将它送到{1}砂带磨床的接触轮处。</translation>
    </message>
    <message>
        <source>The blade has been off the flange since the scans that are there, and scans of two clampings do not belong together. Start this step over and scan it from all sides again.</source>
        <translation>在已有扫描之后叶片曾从法兰上取下，而两次装夹的扫描不能放在一起。请重新开始此步骤，并从各个侧面重新扫描。</translation>
    </message>
    <message>
        <source>The blade has not been clamped and scanned for probing. Clamp it first.</source>
        <translation>还没有为探测装夹和扫描叶片。请先装夹。</translation>
    </message>
    <message>
        <source>The blade has not been scanned after the last line, so nothing shows that it stayed in its clamp.</source>
        <translation>最后一条线之后没有扫描过叶片，因此无法说明它仍停留在夹具中。</translation>
    </message>
    <message>
        <source>The blade is not where it had been clamped: {0} {1}</source>
        <translation>叶片不在原装夹位置：{0}{1}</translation>
    </message>
    <message>
        <source>The blade was clamped anew between its scans, so they do not belong together. Start this step over and scan the blade again.</source>
        <translation>叶片在两次扫描之间重新装夹过，因此这些扫描不能放在一起。请重新开始此步骤，并重新扫描叶片。</translation>
    </message>
    <message>
        <source>The blade, the tool or the calibration has changed: measure a new error surface.</source>
        <translation>叶片、工具或标定已改变：请测量新的误差曲面。</translation>
    </message>
    <message>
        <source>The boundary of this face can&apos;t be used: {0}.</source>
        <translation>该面的边界无法使用：{0}。</translation>
    </message>
    <message>
        <source>The cap seen is too small to determine the ball&apos;s diameter ({0} mm with a sigma of {1} mm). Scan more of the ball, or give its certified diameter with --diameter and --fix-diameter.</source>
        <translation>看到的球冠太小，无法确定标准球直径（{0} mm，sigma 为{1} mm）。请扫描标准球的更大部分，或用 --diameter 和 --fix-diameter 给出其证书直径。</translation>
    </message>
    <message>
        <source>The cell has no grinder {0}. Choose one of {1}.</source>
        <translation>单元中没有{0}砂带磨床。请从{1}中选择。</translation>
    </message>
    <message>
        <source>The closing scan &apos;{0}&apos; is left out, so a ball that moved between the scans might not show. Take it in again, or delete it and scan again.</source>
        <translation>收尾扫描“{0}”被排除，因此扫描期间移动过的标准球可能不会被发现。请重新纳入，或删除后重新扫描。</translation>
    </message>
    <message>
        <source>The closing scan is missing, so a ball that moved between the scans might not show. Take the missing scans; the closing one comes last.</source>
        <translation>缺少收尾扫描，因此扫描期间移动过的标准球可能不会被发现。请采集缺少的扫描；收尾扫描在最后。</translation>
    </message>
    <message>
        <source>The closing scan shows no ball, so nothing shows that it stood still. Delete it and scan again.</source>
        <translation>收尾扫描中没有标准球，因此无法说明它静止不动。请删除后重新扫描。</translation>
    </message>
    <message>
        <source>The condition number (weak: {0})</source>
        <translation>条件数（薄弱：{0}）</translation>
    </message>
    <message>
        <source>The condition of the faces</source>
        <translation>各面的条件数</translation>
    </message>
    <message>
        <source>The condition of the fit</source>
        <translation>拟合的条件数</translation>
    </message>
    <message>
        <source>The diameter cannot be fixed without its value: name the certified diameter in mm.</source>
        <translation>没有直径值就不能固定直径：请给出证书直径（mm）。</translation>
    </message>
    <message>
        <source>The difference between new samples and the stored error surface</source>
        <translation>新样本与已存误差曲面之差</translation>
    </message>
    <message>
        <source>The difference between the fitted ({0} mm) and the certified diameter</source>
        <translation>拟合直径（{0} mm）与证书直径之差</translation>
    </message>
    <message>
        <source>The difference between the fitted ({0} mm) and the expected diameter</source>
        <translation>拟合直径（{0} mm）与预期直径之差</translation>
    </message>
    <message>
        <source>The distance at the wheel between where the blade was presented and where the results of the steps before, as they are now, would present it</source>
        <translation>叶片在接触轮处的实际送检位置，与按前面步骤现有结果应送到的位置之间的距离</translation>
    </message>
    <message>
        <source>The distance between the centres of two halves of the ball</source>
        <translation>标准球两半所得球心之间的距离</translation>
    </message>
    <message>
        <source>The distance between the poses from two halves of the scan</source>
        <translation>扫描两半所得位姿之间的距离</translation>
    </message>
    <message>
        <source>The distance of pair &apos;{0}&apos;</source>
        <translation>点对“{0}”的距离</translation>
    </message>
    <message>
        <source>The distance of the ball from where the first scan saw it, back at the same place after all other scans,</source>
        <translation>在所有其他扫描之后回到同一位置时，标准球与首次扫描所见位置的距离</translation>
    </message>
    <message>
        <source>The distance of the blade from where earlier scans of the same clamping found it</source>
        <translation>叶片与同一次装夹的先前扫描所测位置的距离</translation>
    </message>
    <message>
        <source>The error surface was measured nowhere on this path.</source>
        <translation>该路径上没有任何一处测量过误差曲面。</translation>
    </message>
    <message>
        <source>The errors belong to the frames they were measured by: probe the blade again.</source>
        <translation>误差属于测量时所用的坐标系：请重新探测叶片。</translation>
    </message>
    <message>
        <source>The face is dirty, damaged or not as in the CAD model; or the blade is of another type.</source>
        <translation>该面脏污、损坏或与 CAD 模型不符；或者叶片是另一种型号。</translation>
    </message>
    <message>
        <source>The faces with points ({0}) leave the blade free to move: {1} in the CAD frame (condition {2}, at most {3}).</source>
        <translation>有点的面（{0}）使叶片仍可自由移动：CAD 坐标系中的{1}（条件数{2}，最大{3}）。</translation>
    </message>
    <message>
        <source>The fine step moved the model by {0} mm away from the pose that explains the scan best (at most {1} mm is expected). Check that the blade type is {2} and scan more of edge plate and shroud.</source>
        <translation>精定位步骤使模型偏离最能解释扫描的位姿{0} mm（预期最多{1} mm）。请检查叶片型号是否为{2}，并更多地扫描缘板和叶冠。</translation>
    </message>
    <message>
        <source>The flange orientation changes by only {0} deg: the tip cannot be told from the pivot. Tilt the flange by 20 deg or more about different axes.</source>
        <translation>法兰姿态只变化了{0} deg：无法区分针尖与枢轴点。请绕不同的轴将法兰倾斜 20 deg 或更多。</translation>
    </message>
    <message>
        <source>The flange orientation never changes (largest difference {0} deg): the ball&apos;s offset on the flange and the translation of the measuring frame cannot be told apart. Add at least two poses tilted by 5 deg or more, about different axes.</source>
        <translation>法兰姿态始终不变（最大差别{0} deg）：无法区分标准球在法兰上的偏置与测量坐标系的平移。请至少增加两个绕不同轴倾斜 5 deg 或更多的位姿。</translation>
    </message>
    <message>
        <source>The flange orientations differ by {0} deg at most, {1} deg are needed. Tilt the flange further.</source>
        <translation>法兰姿态最多相差{0} deg，需要{1} deg。请加大法兰的倾斜。</translation>
    </message>
    <message>
        <source>The flange poses and the ball centres do not belong together: the best fit leaves {0} mm RMS on balls spread over {1} mm.{2} Check their order and that the ball did not shift on the flange.</source>
        <translation>法兰位姿与球心不对应：最佳拟合在分布{1} mm 的球上仍留有{0} mm RMS。{2}请检查它们的顺序，以及标准球是否没有在法兰上移位。</translation>
    </message>
    <message>
        <source>The flange poses look inverted (flange_from_base): the tip comes out {0} mm from the flange and the pivot {1} mm from the base. Give base_from_flange.</source>
        <translation>法兰位姿看起来是逆的（flange_from_base）：算出的针尖距法兰{0} mm，枢轴点距基座{1} mm。请给出 base_from_flange。</translation>
    </message>
    <message>
        <source>The flange poses look inverted (flange_from_base): their inverses fit. Give base_from_flange.</source>
        <translation>法兰位姿看起来是逆的（flange_from_base）：取逆后吻合。请给出 base_from_flange。</translation>
    </message>
    <message>
        <source>The flange turns about one axis only, {0} in the flange frame (by up to {1} deg): the tip&apos;s component along it, and the pivot&apos;s along {2} in the base frame, stay free. Add touches tilted by 20 deg or more about another axis.</source>
        <translation>法兰只绕一个轴转动，即法兰坐标系中的{0}（最多{1} deg）：针尖沿该轴的分量，以及枢轴点在基坐标系中沿{2}的分量，没有约束。请增加绕另一轴倾斜 20 deg 或更多的触测。</translation>
    </message>
    <message>
        <source>The flange turns about one axis only, {0} in the flange frame: the ball&apos;s offset along it and the translation of the measuring frame along {1} in the base frame cannot be told apart. Add poses tilted by 5 deg or more about another axis.</source>
        <translation>法兰只绕一个轴转动，即法兰坐标系中的{0}：标准球沿该轴的偏置与测量坐标系在基坐标系中沿{1}的平移无法区分。请增加绕另一轴倾斜 5 deg 或更多的位姿。</translation>
    </message>
    <message>
        <source>The grid node u {0}, v {1} was given {2} times (errors {3} and {4} mm). Keep one sample per node or use smoothing (--smooth).</source>
        <translation>网格节点 u {0}、v {1}给出了{2}次（误差{3}和{4} mm）。每个节点请只保留一个样本，或使用平滑（--smooth）。</translation>
    </message>
    <message>
        <source>The head of grinder {0} has not been read at its stop after the last line.</source>
        <translation>最后一条线之后没有读取过{0}砂带磨床的浮动头在挡块处的读数。</translation>
    </message>
    <message>
        <source>The head of grinder {0} reads {1} degrees at its stop and read {2} degrees in the tool step: {3} mm at the wheel, the limit is {4} mm. {5}</source>
        <translation>{0}砂带磨床的浮动头在挡块处读数为{1}度，工具步骤时为{2}度：在接触轮处为{3} mm，限值为{4} mm。{5}</translation>
    </message>
    <message>
        <source>The head turns {0} times what its sensor says (standard deviation {1}). Check the sensor&apos;s steps per turn.</source>
        <translation>浮动头的转角是其传感器示值的{0}倍（标准差{1}）。请检查传感器每转的步数。</translation>
    </message>
    <message>
        <source>The head&apos;s axis points against the direction expected: the angle sensor counts the wrong way round. Reverse its sign.</source>
        <translation>浮动头轴的指向与预期相反：角度传感器计数方向错误。请将其符号反向。</translation>
    </message>
    <message>
        <source>The job was cancelled.</source>
        <translation>作业已取消。</translation>
    </message>
    <message>
        <source>The largest error</source>
        <translation>最大误差</translation>
    </message>
    <message>
        <source>The largest held-out angle error</source>
        <translation>最大留出角度误差</translation>
    </message>
    <message>
        <source>The largest held-out distance</source>
        <translation>最大留出距离</translation>
    </message>
    <message>
        <source>The largest held-out error</source>
        <translation>最大留出误差</translation>
    </message>
    <message>
        <source>The latest result of the step &apos;{0}&apos; is not good enough to accept: {1}</source>
        <translation>步骤“{0}”的最新结果不够好，不能接受：{1}</translation>
    </message>
    <message>
        <source>The leave-one-out error (RMS)</source>
        <translation>留一法误差（RMS）</translation>
    </message>
    <message>
        <source>The list of faces is empty.</source>
        <translation>面的列表为空。</translation>
    </message>
    <message>
        <source>The list of faces is empty. Name at least three, or none to use all.</source>
        <translation>面的列表为空。请至少指定三个，或不指定以使用全部。</translation>
    </message>
    <message>
        <source>The mean distance of {0} under the pose of the other faces</source>
        <translation>{0}在其他面所得位姿下的平均距离</translation>
    </message>
    <message>
        <source>The name of an input file is empty.</source>
        <translation>有一个输入文件的名称为空。</translation>
    </message>
    <message>
        <source>The name of the file to write holds a null character, expected a file name.</source>
        <translation>要写出的文件名含有空字符，应为文件名。</translation>
    </message>
    <message>
        <source>The noise of one sample</source>
        <translation>单个样本的噪声</translation>
    </message>
    <message>
        <source>The noise of the ball&apos;s surface</source>
        <translation>标准球表面的噪声</translation>
    </message>
    <message>
        <source>The observations just determine the stage and leave nothing to check it with. Add one position.</source>
        <translation>这些观测刚好能确定位移台，没有多余的可用来检验。请增加一个位置。</translation>
    </message>
    <message>
        <source>The path leaves what was measured: (u {0}, v {1}) lies {2}, which spans u {3} to {4}, v {5} to {6} ({7} points of this line). Narrow u_range and v_range, measure there, or set clip = true to leave those points out.</source>
        <translation>路径超出测量范围：(u {0}, v {1}) 位于{2}，其范围为 u {3}到{4}、v {5}到{6}（该线上有{7}个点）。请缩小 u_range 和 v_range，在该处测量，或设置 clip = true 以去掉这些点。</translation>
    </message>
    <message>
        <source>The pattern has more than {0} points. Choose a larger step_mm or spacing_mm.</source>
        <translation>走刀方式超过{0}个点。请选择更大的 step_mm 或 spacing_mm。</translation>
    </message>
    <message>
        <source>The picks are a mirror image of each other: {0} mm RMS if one set is reflected, {1} mm if it is not. Check that left and right (or a sign) are the same on the scan and on the CAD model, and pick again.</source>
        <translation>两组选点互为镜像：将一组反射后为{0} mm RMS，不反射为{1} mm。请检查扫描和 CAD 模型上的左右（或符号）是否一致，然后重新选取。</translation>
    </message>
    <message>
        <source>The picks {0} all lie within {1} mm of each other. Pick points that are spread over the whole blade.</source>
        <translation>选点{0}彼此都在{1} mm 以内。请选取分布在整个叶片上的点。</translation>
    </message>
    <message>
        <source>The picks {0} lie on a line along ({1}): {2} mm RMS off it over a length of {3} mm, so the rotation about that line is not determined. Pick at least one point well off the line.</source>
        <translation>选点{0}位于沿 ({1}) 的一条直线上：在{3} mm 长度上偏离{2} mm RMS，因此绕该直线的旋转无法确定。请至少选取一个明显偏离该直线的点。</translation>
    </message>
    <message>
        <source>The picks {0} look like {1}: distances between them are {2} times smaller there than in the other set. Give both in mm.</source>
        <translation>选点{0}的单位看起来是{1}：其点间距离比另一组小{2}倍。两者都请用 mm 给出。</translation>
    </message>
    <message>
        <source>The points on {0} hold the blade too loosely: one sigma of {1} mm at an end of the model, at most {2} mm. Weakest: {3} in the CAD frame. Scan more points or more faces.</source>
        <translation>{0}上的点对叶片约束太松：模型一端的 sigma 为{1} mm，最大{2} mm。最弱：CAD 坐标系中的{3}。请扫描更多的点或更多的面。</translation>
    </message>
    <message>
        <source>The pose found carries the model by up to {0} mm from the start, at most {1} mm is trusted: another pose may fit as well. Redo the rough step, or check the start.</source>
        <translation>找到的位姿使模型偏离初值达{0} mm，最多信任{1} mm：另一个位姿可能同样吻合。请重做粗定位步骤，或检查初值。</translation>
    </message>
    <message>
        <source>The pose has not settled after {0} passes (last step {1} µm, {2} µrad). The faces seen hold it too loosely or contradict each other; scan more faces.</source>
        <translation>位姿在{0}轮后没有稳定（最后一步{1} µm、{2} µrad）。看到的面约束太松或互相矛盾；请扫描更多的面。</translation>
    </message>
    <message>
        <source>The poses do not determine the measuring frame: standard deviation {0} deg and {1} mm with this noise. Weakest: {2}. Add poses that move the ball to the sides and tilt the flange more.</source>
        <translation>这些位姿不能确定测量坐标系：在此噪声下标准差为{0} deg 和{1} mm。最弱：{2}。请增加把标准球移到两侧并加大法兰倾斜的位姿。</translation>
    </message>
    <message>
        <source>The poses leave something nearly free: {0} (condition {1}, usable below {2}). Add poses that move the ball by 50 mm or more and tilt the flange by 5 deg or more about different axes.</source>
        <translation>这些位姿使某个量几乎没有约束：{0}（条件数{1}，低于{2}才可用）。请增加把标准球移动 50 mm 或更多、并绕不同轴将法兰倾斜 5 deg 或更多的位姿。</translation>
    </message>
    <message>
        <source>The radius given is {0} mm, the touches say {1} mm (standard deviation {2} mm). Check the radius and the angle sensor&apos;s scale.</source>
        <translation>给出的半径为{0} mm，触测所得为{1} mm（标准差{2} mm）。请检查半径和角度传感器的比例系数。</translation>
    </message>
    <message>
        <source>The range along which the lines run has no length.</source>
        <translation>各线所沿的范围没有长度。</translation>
    </message>
    <message>
        <source>The robot moved by {0} mm between the scans &apos;{1}&apos; and &apos;{2}&apos;; all scans of one blade must be taken in the same robot pose. Scan again.</source>
        <translation>机器人在扫描“{1}”和“{2}”之间移动了{0} mm；一个叶片的所有扫描必须在同一机器人位姿下采集。请重新扫描。</translation>
    </message>
    <message>
        <source>The robot moves {0}.</source>
        <translation>机器人移动：{0}。</translation>
    </message>
    <message>
        <source>The rotary axis needs at least three angles, or two with a linear move at each.</source>
        <translation>旋转轴至少需要三个角度，或两个角度且每个角度下有一次直线移动。</translation>
    </message>
    <message>
        <source>The rotary axis stands at {0} rad but was calibrated at {1} rad only. Turn it back, or calibrate with the rotary axis moved.</source>
        <translation>旋转轴停在{0} rad，但只在{1} rad 处标定过。请将其转回，或在旋转轴转动的情况下标定。</translation>
    </message>
    <message>
        <source>The rotations of the flange poses look transposed: their transposes fit. Check the order of the matrix.</source>
        <translation>法兰位姿的旋转看起来被转置了：转置后吻合。请检查矩阵的顺序。</translation>
    </message>
    <message>
        <source>The sample at u {0}, v {1} is {2} mm off its neighbours (limit {3} mm; {4} samples beyond it, neighbours of bad ones among them). Interpolation would go through it.</source>
        <translation>u {0}、v {1}处的样本与相邻样本相差{2} mm（限值{3} mm；超出的样本有{4}个，其中包括坏样本的相邻样本）。插值会穿过它。</translation>
    </message>
    <message>
        <source>The samples lie on one line of the airfoil; a surface needs samples that spread in u and in v. Measure several lines.</source>
        <translation>样本都在叶身的一条线上；曲面需要在 u 和 v 方向都有分布的样本。请测量多条线。</translation>
    </message>
    <message>
        <source>The samples or settings of the step &apos;{0}&apos; changed since it was solved. Solve it again.</source>
        <translation>步骤“{0}”的样本或设置在求解后已改变。请重新求解。</translation>
    </message>
    <message>
        <source>The scale error of axis {0} ({1} mm per mm)</source>
        <translation>轴{0}的比例误差（{1} mm/mm）</translation>
    </message>
    <message>
        <source>The scan does not fit the model: of {0} points within 2 mm of its faces only {1} lie on them, at least {2} are expected. Is it the right blade type, and is the start within a few mm and degrees?</source>
        <translation>扫描与模型不符：距模型各面 2 mm 以内的{0}个点中只有{1}落在面上，至少应为{2}。叶片型号是否正确？初值是否在几 mm 和几度以内？</translation>
    </message>
    <message>
        <source>The scan does not fit the model: points scatter by {0} mm about its faces, at most {1} mm is scanner noise. Is it the right blade type, and is the start within a few mm and degrees?</source>
        <translation>扫描与模型不符：点在模型各面附近离散{0} mm，扫描仪噪声最多为{1} mm。叶片型号是否正确？初值是否在几 mm 和几度以内？</translation>
    </message>
    <message>
        <source>The scan does not fit the model: {0} of its faces agree with the scan, {1} contradict it, and {2} of the surface scanned near the faces lies on them (at least {3} is usual). Is it the right blade type, and is the start within a few mm and degrees?</source>
        <translation>扫描与模型不符：有{0}个面与扫描一致，{1}个面与之矛盾，各面附近扫描到的表面有{2}落在面上（通常至少{3}）。叶片型号是否正确？初值是否在几 mm 和几度以内？</translation>
    </message>
    <message>
        <source>The scan does not fit {0}: in the best pose {1} of the points near the model lie on it ({2} is needed), and of those parallel to its faces {3} ({4} is needed). Check the blade type.</source>
        <translation>扫描与{0}不符：在最佳位姿下，模型附近的点有{1}落在模型上（需要{2}），与其各面平行的点有{3}（需要{4}）。请检查叶片型号。</translation>
    </message>
    <message>
        <source>The scan fits {0} in two ways ({1}), {2} degrees and up to {3} mm apart. Scan an area that tells them apart too, such as the airfoil next to the edge plate, or pick pairs of points.</source>
        <translation>扫描与{0}有两种吻合方式（{1}），彼此相差{2}度、最多{3} mm。请再扫描一块能区分两者的区域，例如缘板旁边的叶身，或选取点对。</translation>
    </message>
    <message>
        <source>The scan has {0} points, at least 500 are needed to find the blade in it.</source>
        <translation>扫描有{0}个点，要在其中找到叶片至少需要 500 个。</translation>
    </message>
    <message>
        <source>The scan has {0} points, at least {1} are needed.</source>
        <translation>扫描有{0}个点，至少需要{1}个。</translation>
    </message>
    <message>
        <source>The scan is only {0} mm across, the model {1} mm. Give a scan in mm that covers several faces.</source>
        <translation>扫描只有{0} mm 宽，模型为{1} mm。请给出以 mm 为单位、覆盖多个面的扫描。</translation>
    </message>
    <message>
        <source>The scan is {0} mm across and {1} {2} mm. Give both in mm.</source>
        <translation>扫描宽{0} mm，{1}为{2} mm。两者都请用 mm 给出。</translation>
    </message>
    <message>
        <source>The scan is {0} mm across and {1} {2} mm.{3} Give the scan in mm, and edge plate and shroud together.</source>
        <translation>扫描宽{0} mm，{1}为{2} mm。{3}请以 mm 给出扫描，并同时包含缘板和叶冠。</translation>
    </message>
    <message>
        <source>The scan is {0} mm across, the model {1} mm: one of them has the wrong unit. Give both in mm.</source>
        <translation>扫描宽{0} mm，模型宽{1} mm：其中一个的单位不对。两者都请用 mm 给出。</translation>
    </message>
    <message>
        <source>The scan is {0} mm across, the model {1} mm: the scan seems to be in metres. Give it in mm.</source>
        <translation>扫描宽{0} mm，模型宽{1} mm：扫描的单位似乎是米。请用 mm 给出。</translation>
    </message>
    <message>
        <source>The scanner&apos;s stride must be 1 or more, found {0}.</source>
        <translation>扫描仪的步长必须为 1 或更大，现为{0}。</translation>
    </message>
    <message>
        <source>The session has no sample {0}.</source>
        <translation>会话中没有样本{0}。</translation>
    </message>
    <message>
        <source>The set of rejected samples does not settle: good and bad samples cannot be told apart. Measure the airfoil again.</source>
        <translation>被剔除样本的集合不能稳定：无法区分好样本与坏样本。请重新测量叶身。</translation>
    </message>
    <message>
        <source>The share of missing samples</source>
        <translation>缺失样本的比例</translation>
    </message>
    <message>
        <source>The share of rejected samples</source>
        <translation>剔除样本的比例</translation>
    </message>
    <message>
        <source>The speed of a clock must be positive, found {0}.</source>
        <translation>时钟速度必须为正，现为{0}。</translation>
    </message>
    <message>
        <source>The sphere fit was still moving. Scan the ball again.</source>
        <translation>球面拟合仍在变动。请重新扫描标准球。</translation>
    </message>
    <message>
        <source>The sphericity</source>
        <translation>球度</translation>
    </message>
    <message>
        <source>The squareness error of {0}</source>
        <translation>{0}的垂直度误差</translation>
    </message>
    <message>
        <source>The stage fit has no covariance: give the noise of the ball centres or add observations.</source>
        <translation>位移台拟合没有协方差：请给出球心噪声，或增加观测。</translation>
    </message>
    <message>
        <source>The stage fit was still moving after its iterations. {0}</source>
        <translation>位移台拟合在迭代结束后仍在变动。{0}</translation>
    </message>
    <message>
        <source>The standard deviation of the axis direction</source>
        <translation>轴方向的标准差</translation>
    </message>
    <message>
        <source>The standard deviation of the ball offset</source>
        <translation>标准球偏置的标准差</translation>
    </message>
    <message>
        <source>The standard deviation of the position</source>
        <translation>位置的标准差</translation>
    </message>
    <message>
        <source>The standard deviation of the radius</source>
        <translation>半径的标准差</translation>
    </message>
    <message>
        <source>The standard deviation of the rotation</source>
        <translation>旋转的标准差</translation>
    </message>
    <message>
        <source>The standard deviation of the tip</source>
        <translation>针尖的标准差</translation>
    </message>
    <message>
        <source>The standard deviation of the wheel centre</source>
        <translation>轮心的标准差</translation>
    </message>
    <message>
        <source>The step &apos;{0}&apos; has no result yet. Solve it first.</source>
        <translation>步骤“{0}”还没有结果。请先求解。</translation>
    </message>
    <message>
        <source>The step &apos;{0}&apos; has no result yet; the error surface stands on it. Do that step first.</source>
        <translation>步骤“{0}”还没有结果；误差曲面以它为依据。请先完成该步骤。</translation>
    </message>
    <message>
        <source>The surfaces belong to different blade types ({0}).</source>
        <translation>这些曲面属于不同的叶片型号（{0}）。</translation>
    </message>
    <message>
        <source>The surfaces have no measured patch in common.</source>
        <translation>这些曲面没有共同的测量区域。</translation>
    </message>
    <message>
        <source>The touches do not determine the head&apos;s axis: over an arc of {0} deg its direction is known to {1} deg and its place to {2} mm (one standard deviation) with {3} mm of touch noise. {4}</source>
        <translation>这些触测不能确定浮动头的轴：在{0} deg 的弧段上，触测噪声为{3} mm 时，其方向只能确定到{1} deg，位置只能确定到{2} mm（一倍标准差）。{4}</translation>
    </message>
    <message>
        <source>The touches do not determine the tip along {0} in the flange frame: standard deviation {1} mm. Tilt the flange further about the axes across it, and check touch {2} (counted from 0) first.</source>
        <translation>这些触测不能确定针尖在法兰坐标系中沿{0}的位置：标准差{1} mm。请绕与之垂直的轴加大法兰的倾斜，并先检查触测{2}（从 0 计）。</translation>
    </message>
    <message>
        <source>The touches lie on a straight line: no circle and no axis follows from them. Turn the head farther between touches.</source>
        <translation>触测点都在一条直线上：由此得不出圆和轴。请在两次触测之间把浮动头转得更大。</translation>
    </message>
    <message>
        <source>The touches span {0} deg; {1}. Turn the head farther or add touches.</source>
        <translation>触测跨越{0} deg；{1}。请把浮动头转得更大，或增加触测。</translation>
    </message>
    <message>
        <source>The uncertainty (one sigma) of the position at an end of the blade</source>
        <translation>叶片一端位置的不确定度（一倍 sigma）</translation>
    </message>
    <message>
        <source>The uncertainty of the ball in the measurement frame</source>
        <translation>标准球在测量坐标系中的不确定度</translation>
    </message>
    <message>
        <source>The uncertainty of the ball&apos;s centre</source>
        <translation>球心的不确定度</translation>
    </message>
    <message>
        <source>The wheel fit did not settle from any start. Turn the head farther between touches and repeat them.</source>
        <translation>接触轮拟合从任何初值都没有稳定。请在两次触测之间把浮动头转得更大，并重做触测。</translation>
    </message>
    <message>
        <source>The {0} has fewer than two flat areas of different direction, which the automatic search needs. Scan edge plate and shroud from the side, or pick pairs of points.</source>
        <translation>{0}中方向不同的平面区域少于两个，而自动搜索需要它们。请从侧面扫描缘板和叶冠，或选取点对。</translation>
    </message>
    <message>
        <source>The {0} is predicted with an RMS error of {1} mm at {2} observations kept out of the fit, the limit is {3} mm. {4}</source>
        <translation>在{2}个留在拟合之外的观测上，{0}的预测误差 RMS 为{1} mm，限值为{3} mm。{4}</translation>
    </message>
    <message>
        <source>The {0} samples are not on a grid ({1} different u, {2} different v). Interpolation needs a full grid; use smoothing (--smooth) for scattered samples.</source>
        <translation>{0}个样本不在网格上（{1}个不同的 u，{2}个不同的 v）。插值需要完整网格；散乱样本请使用平滑（--smooth）。</translation>
    </message>
    <message>
        <source>There are no scans of the blade. Scan it first.</source>
        <translation>没有叶片的扫描。请先扫描。</translation>
    </message>
    <message>
        <source>There are {0} different poses, {1} are needed so that a bad touch would show. Add touches.</source>
        <translation>有{0}个不同的位姿，需要{1}个才能看出错误的触测。请增加触测。</translation>
    </message>
    <message>
        <source>There are {0} different poses, {1} are needed so that a mistake would show. Add poses with the flange tilted.</source>
        <translation>有{0}个不同的位姿，需要{1}个才能看出错误。请增加法兰倾斜的位姿。</translation>
    </message>
    <message>
        <source>There are {0} names for {1} pairs; each pair needs one.</source>
        <translation>{1}个点对有{0}个名称；每个点对需要一个。</translation>
    </message>
    <message>
        <source>There are {0} pairs, at least {1} are asked for so that a bad pick shows. Pick more pairs.</source>
        <translation>有{0}个点对，要求至少{1}个才能看出错误的选点。请选取更多点对。</translation>
    </message>
    <message>
        <source>There are {0} picks on the scan and {1} on the CAD model; each pair needs both.</source>
        <translation>扫描上有{0}个选点，CAD 模型上有{1}个；每个点对两者都需要。</translation>
    </message>
    <message>
        <source>There are {0} touches at different places, {1} are needed so that a mistake would show. Touch the shaft at more head angles.</source>
        <translation>有{0}个不同位置的触测，需要{1}个才能看出错误。请在更多浮动头角度下触测轮轴。</translation>
    </message>
    <message>
        <source>There is no reading of the head of grinder {0} at its stop</source>
        <translation>没有{0}砂带磨床的浮动头在挡块处的读数</translation>
    </message>
    <message>
        <source>This is more than a blade differs from its design: check base, fine and tool before compensating.</source>
        <translation>这已超过叶片与其设计之间的差别：补偿前请检查基坐标系、精定位和工具步骤。</translation>
    </message>
    <message>
        <source>Touch the centre mark again; see that the head was held still.</source>
        <translation>请重新触测中心标记；确认浮动头保持不动。</translation>
    </message>
    <message>
        <source>Touch the cone again, pressing lightly, and see that the stylus sits tight.</source>
        <translation>请轻压重新触测锥窝，并确认测针固定牢靠。</translation>
    </message>
    <message>
        <source>Touch {0} of {1}: guide the stylus tip into the cone, tilted in another direction than before by 20 degrees or more, let go, then confirm.</source>
        <translation>触测{0}/{1}：将测针针尖引导到锥窝内，倾斜方向与之前相差 20 度或更多，松手，然后确认。</translation>
    </message>
    <message>
        <source>Turn the head of grinder {0} to {1} degrees, hold it, touch the centre mark of the wheel shaft with the stylus tip, then confirm.</source>
        <translation>将{0}砂带磨床的浮动头转到{1}度并保持，用测针针尖触碰轮轴的中心标记，然后确认。</translation>
    </message>
    <message>
        <source>Turn the head over {0} deg or more.</source>
        <translation>请将浮动头转过{0} deg 或更多。</translation>
    </message>
    <message>
        <source>Two different answers fit these {0} poses about equally well ({1} and {2} mm RMS). Add poses tilted by 5 deg or more about other axes.</source>
        <translation>两个不同的答案与这{0}个位姿吻合得差不多（{1}和{2} mm RMS）。请增加绕其他轴倾斜 5 deg 或更多的位姿。</translation>
    </message>
    <message>
        <source>Uncertainty (1 sigma) of the position</source>
        <translation>位置的不确定度（1 sigma）</translation>
    </message>
    <message>
        <source>Uncertainty (1 sigma) of the rotation</source>
        <translation>旋转的不确定度（1 sigma）</translation>
    </message>
    <message>
        <source>Warming up</source>
        <translation>正在预热</translation>
    </message>
    <message>
        <source>Was the radius given instead of the diameter?</source>
        <translation>是否给成了半径而不是直径？</translation>
    </message>
    <message>
        <source>Weakest is {0} in the CAD frame; scan faces that hold it.</source>
        <translation>最弱的是 CAD 坐标系中的{0}；请扫描能约束它的面。</translation>
    </message>
    <message>
        <source>Weakest: {0}. Add poses that tilt the flange more and about other axes.</source>
        <translation>最弱：{0}。请增加更大倾斜且绕其他轴倾斜法兰的位姿。</translation>
    </message>
    <message>
        <source>Weakest: {0}. Tilt the flange further and about other axes.</source>
        <translation>最弱：{0}。请绕其他轴加大法兰的倾斜。</translation>
    </message>
    <message>
        <source>What was probed in the earlier clamping does not count any more; the blade is clamped and probed anew.</source>
        <translation>先前装夹中探测的内容不再有效；叶片将重新装夹并探测。</translation>
    </message>
    <message>
        <source>Without observation {0} (counted from 0) it would be {1} mm: look at that one first.</source>
        <translation>去掉观测{0}（从 0 计）后为{1} mm：请先查看它。</translation>
    </message>
    <message>
        <source>Without {0} the other picks lie on a line, so nothing checks it: pick one more pair away from that line.</source>
        <translation>没有{0}时其他选点都在一条直线上，因此没有什么能检验它：请在该直线之外再选一个点对。</translation>
    </message>
    <message>
        <source>a copy reaches past the end</source>
        <translation>复制范围超出了结尾</translation>
    </message>
    <message>
        <source>a copy starts before the beginning</source>
        <translation>复制起点在开头之前</translation>
    </message>
    <message>
        <source>a literal run reaches past the end</source>
        <translation>字面量范围超出了结尾</translation>
    </message>
    <message>
        <source>a loop goes around the axis without a seam</source>
        <translation>有一个环绕轴一周而没有接缝</translation>
    </message>
    <message>
        <source>a loop has a gap of {0} mm</source>
        <translation>有一个环存在{0} mm 的间隙</translation>
    </message>
    <message>
        <source>a loop has no area</source>
        <translation>有一个环没有面积</translation>
    </message>
    <message>
        <source>a loop has no edges</source>
        <translation>有一个环没有边</translation>
    </message>
    <message>
        <source>about {0} deg would do</source>
        <translation>约{0} deg 即可</translation>
    </message>
    <message>
        <source>above</source>
        <translation>高于</translation>
    </message>
    <message>
        <source>accept</source>
        <translation>接受</translation>
    </message>
    <message>
        <source>accepted</source>
        <translation>已接受</translation>
    </message>
    <message>
        <source>acquire</source>
        <translation>采集</translation>
    </message>
    <message>
        <source>after</source>
        <translation>after</translation>
    </message>
    <message>
        <source>airfoil</source>
        <translation>叶身</translation>
    </message>
    <message>
        <source>airfoil: expected the number or the name of a face, found {0}.</source>
        <translation>airfoil：应为面的编号或名称，现为{0}。</translation>
    </message>
    <message>
        <source>all</source>
        <translation>全部</translation>
    </message>
    <message>
        <source>an STL file has at least {0} bytes, found {1}. The file is cut short.</source>
        <translation>STL 文件至少有{0}字节，现为{1}。文件被截断。</translation>
    </message>
    <message>
        <source>and others</source>
        <translation>等</translation>
    </message>
    <message>
        <source>angle</source>
        <translation>angle</translation>
    </message>
    <message>
        <source>angle scale</source>
        <translation>角度比例系数</translation>
    </message>
    <message>
        <source>angle, sample {0}: {1} degrees is more than a head in contact can turn (57 degrees). Check the unit of the angle and the sensor&apos;s zero.</source>
        <translation>角度，样本{0}：{1}度超出了接触状态下浮动头所能转动的范围（57 度）。请检查角度的单位和传感器的零点。</translation>
    </message>
    <message>
        <source>angle_rad: the head angles span {0} rad, more than a full turn. They look like degrees.</source>
        <translation>angle_rad：浮动头角度跨越{0} rad，超过一整圈。看起来单位是度。</translation>
    </message>
    <message>
        <source>angle_rad: the head angles {0}</source>
        <translation>angle_rad：浮动头角度{0}</translation>
    </message>
    <message>
        <source>another program</source>
        <translation>另一个程序</translation>
    </message>
    <message>
        <source>approach_mm: expected a distance above 0 and up to 500 mm, found {0}.</source>
        <translation>approach_mm：应为大于 0 且不超过 500 mm 的距离，现为{0}。</translation>
    </message>
    <message>
        <source>attention</source>
        <translation>attention</translation>
    </message>
    <message>
        <source>away from the wheel, back to the scanning pose</source>
        <translation>离开接触轮，回到扫描位姿</translation>
    </message>
    <message>
        <source>axis point along tool {0}</source>
        <translation>轴上的点沿工具{0}</translation>
    </message>
    <message>
        <source>axis {0} along scanner {1}</source>
        <translation>轴{0}沿扫描仪{1}</translation>
    </message>
    <message>
        <source>ball</source>
        <translation>标准球</translation>
    </message>
    <message>
        <source>ball by the robot</source>
        <translation>机器人所得的球</translation>
    </message>
    <message>
        <source>ball centre in {B}</source>
        <translation>{B} 中的球心</translation>
    </message>
    <message>
        <source>ball centre in {M}</source>
        <translation>{M} 中的球心</translation>
    </message>
    <message>
        <source>ball centres</source>
        <translation>球心</translation>
    </message>
    <message>
        <source>ball offset along flange</source>
        <translation>标准球偏置沿法兰</translation>
    </message>
    <message>
        <source>ball x</source>
        <translation>球 x</translation>
    </message>
    <message>
        <source>ball y</source>
        <translation>球 y</translation>
    </message>
    <message>
        <source>ball z</source>
        <translation>球 z</translation>
    </message>
    <message>
        <source>ball_covariance_mm2: NaN or infinite number.</source>
        <translation>ball_covariance_mm2：含有 NaN 或无穷大。</translation>
    </message>
    <message>
        <source>ball_covariance_mm2: expected {0} matrices 3x3, found shape {1}.</source>
        <translation>ball_covariance_mm2：应为{0}个 3x3 矩阵，现形状为{1}。</translation>
    </message>
    <message>
        <source>ball_in_measure_mm: expected N points of three numbers, found shape {0}.</source>
        <translation>ball_in_measure_mm：应为 N 个三个数的点，现形状为{0}。</translation>
    </message>
    <message>
        <source>ball_in_measure_mm: expected N points of three numbers.</source>
        <translation>ball_in_measure_mm：应为 N 个三个数的点。</translation>
    </message>
    <message>
        <source>ball_in_measure_mm: the balls are spread over only {0} while the flange moved {1} mm. That looks like metres; ball centres must be in mm.</source>
        <translation>ball_in_measure_mm：各球只分布在{0}范围内，而法兰移动了{1} mm。看起来单位是米；球心必须用 mm。</translation>
    </message>
    <message>
        <source>ball_in_scanner_mm: no ball has a coordinate above {0}, expected a working distance in mm. The ball centres look like metres.</source>
        <translation>ball_in_scanner_mm：没有球的坐标大于{0}，应为以 mm 计的工作距离。球心的单位看起来是米。</translation>
    </message>
    <message>
        <source>base</source>
        <translation>基座</translation>
    </message>
    <message>
        <source>base_from_flange: expected N matrices 4x4, found shape {0}.</source>
        <translation>base_from_flange：应为 N 个 4x4 矩阵，现形状为{0}。</translation>
    </message>
    <message>
        <source>base_from_flange: expected N matrices of 4x4 numbers.</source>
        <translation>base_from_flange：应为 N 个 4x4 数字矩阵。</translation>
    </message>
    <message>
        <source>base_from_flange: no flange is farther than {0} from the robot base. That looks like metres; positions must be in mm.</source>
        <translation>base_from_flange：没有法兰距机器人基座超过{0}。看起来单位是米；位置必须用 mm。</translation>
    </message>
    <message>
        <source>before</source>
        <translation>before</translation>
    </message>
    <message>
        <source>below</source>
        <translation>低于</translation>
    </message>
    <message>
        <source>beltcal {0}</source>
        <translation>beltcal {0}</translation>
    </message>
    <message>
        <source>blade</source>
        <translation>叶片</translation>
    </message>
    <message>
        <source>blades</source>
        <translation>blades</translation>
    </message>
    <message>
        <source>box</source>
        <translation>box</translation>
    </message>
    <message>
        <source>bspline</source>
        <translation>B 样条</translation>
    </message>
    <message>
        <source>build</source>
        <translation>build</translation>
    </message>
    <message>
        <source>by pairs</source>
        <translation>由点对</translation>
    </message>
    <message>
        <source>cad</source>
        <translation>cad</translation>
    </message>
    <message>
        <source>cancelled</source>
        <translation>已取消</translation>
    </message>
    <message>
        <source>candidate_base_from_flange: give at least one pose.</source>
        <translation>candidate_base_from_flange：请至少给出一个位姿。</translation>
    </message>
    <message>
        <source>cell</source>
        <translation>单元</translation>
    </message>
    <message>
        <source>cells</source>
        <translation>cells</translation>
    </message>
    <message>
        <source>centimetres</source>
        <translation>厘米</translation>
    </message>
    <message>
        <source>centre mark of grinder {0}</source>
        <translation>{0}砂带磨床的中心标记</translation>
    </message>
    <message>
        <source>check</source>
        <translation>检验</translation>
    </message>
    <message>
        <source>check line {0} of {1}</source>
        <translation>检验线{0}/{1}</translation>
    </message>
    <message>
        <source>chosen</source>
        <translation>已选</translation>
    </message>
    <message>
        <source>clamping</source>
        <translation>装夹</translation>
    </message>
    <message>
        <source>clip</source>
        <translation>clip</translation>
    </message>
    <message>
        <source>clouds</source>
        <translation>clouds</translation>
    </message>
    <message>
        <source>comparing with where the blade was</source>
        <translation>正在与叶片原来的位置比较</translation>
    </message>
    <message>
        <source>compensated path</source>
        <translation>补偿后路径</translation>
    </message>
    <message>
        <source>concave</source>
        <translation>凹</translation>
    </message>
    <message>
        <source>cone</source>
        <translation>锥窝</translation>
    </message>
    <message>
        <source>cone touch {0} of {1}</source>
        <translation>锥窝触测{0}/{1}</translation>
    </message>
    <message>
        <source>cone&apos;s point</source>
        <translation>锥窝点</translation>
    </message>
    <message>
        <source>convex</source>
        <translation>凸</translation>
    </message>
    <message>
        <source>count</source>
        <translation>count</translation>
    </message>
    <message>
        <source>count: expected at least 1 line, found {0}.</source>
        <translation>count：应至少为 1 条线，现为{0}。</translation>
    </message>
    <message>
        <source>count: expected at most {0} lines, found {1}.</source>
        <translation>count：应最多为{0}条线，现为{1}。</translation>
    </message>
    <message>
        <source>count: {0} lines need a {1} with a length, found {2}. Give count = 1.</source>
        <translation>count：{0}条线需要有长度的{1}，现为{2}。请给出 count = 1。</translation>
    </message>
    <message>
        <source>create</source>
        <translation>create</translation>
    </message>
    <message>
        <source>cylinder</source>
        <translation>圆柱</translation>
    </message>
    <message>
        <source>date</source>
        <translation>date</translation>
    </message>
    <message>
        <source>deg</source>
        <translation>deg</translation>
    </message>
    <message>
        <source>demo</source>
        <translation>demo</translation>
    </message>
    <message>
        <source>description</source>
        <translation>description</translation>
    </message>
    <message>
        <source>directions of the scan&apos;s surfaces</source>
        <translation>扫描各表面的方向</translation>
    </message>
    <message>
        <source>distance from the base</source>
        <translation>距基座的距离</translation>
    </message>
    <message>
        <source>distance from the scanner</source>
        <translation>距扫描仪的距离</translation>
    </message>
    <message>
        <source>diverging</source>
        <translation>diverging</translation>
    </message>
    <message>
        <source>done</source>
        <translation>完成</translation>
    </message>
    <message>
        <source>done again: {0}</source>
        <translation>已重做：{0}</translation>
    </message>
    <message>
        <source>dropped</source>
        <translation>dropped</translation>
    </message>
    <message>
        <source>edge_margin_mm must lie between 0 and edge_zone_mm, found {0}.</source>
        <translation>edge_margin_mm 必须在 0 与 edge_zone_mm 之间，现为{0}。</translation>
    </message>
    <message>
        <source>engine stop</source>
        <translation>engine stop</translation>
    </message>
    <message>
        <source>error_mm, sample {0}: {1} mm is out of reach of a head of radius {2} mm.</source>
        <translation>error_mm，样本{0}：{1} mm 超出了半径为{2} mm 的浮动头的范围。</translation>
    </message>
    <message>
        <source>error_mm: the typical error is {0}, which no blade in a cell has in mm. Check the unit (micrometres?).</source>
        <translation>error_mm：典型误差为{0}，单元中没有叶片会有这样的 mm 值。请检查单位（是否微米？）。</translation>
    </message>
    <message>
        <source>error_surface: the file does not hold an error surface.</source>
        <translation>error_surface：文件中没有误差曲面。</translation>
    </message>
    <message>
        <source>excluded</source>
        <translation>excluded</translation>
    </message>
    <message>
        <source>export</source>
        <translation>导出</translation>
    </message>
    <message>
        <source>face 0</source>
        <translation>面 0</translation>
    </message>
    <message>
        <source>face 1</source>
        <translation>面 1</translation>
    </message>
    <message>
        <source>face 2</source>
        <translation>面 2</translation>
    </message>
    <message>
        <source>face 3</source>
        <translation>面 3</translation>
    </message>
    <message>
        <source>face 4</source>
        <translation>面 4</translation>
    </message>
    <message>
        <source>face 5</source>
        <translation>面 5</translation>
    </message>
    <message>
        <source>face 6</source>
        <translation>面 6</translation>
    </message>
    <message>
        <source>face 7</source>
        <translation>面 7</translation>
    </message>
    <message>
        <source>face {0}</source>
        <translation>面{0}</translation>
    </message>
    <message>
        <source>faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>faces of the CAD model</source>
        <translation>CAD 模型的面</translation>
    </message>
    <message>
        <source>finding its reference</source>
        <translation>正在回参考点</translation>
    </message>
    <message>
        <source>fine</source>
        <translation>精磨</translation>
    </message>
    <message>
        <source>fit</source>
        <translation>拟合</translation>
    </message>
    <message>
        <source>fitting the error surface</source>
        <translation>正在拟合误差曲面</translation>
    </message>
    <message>
        <source>flange_from_work: give either this or {0}, not both.</source>
        <translation>flange_from_work：请给出它或{0}，不要两个都给。</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is no serial number of the blade type {1}; expected the pattern {2}. Scan it again.</source>
        <translation>“{0}”不是叶片型号{1}的序列号；应符合格式{2}。请重新扫码。</translation>
    </message>
    <message>
        <source>&apos;{0}&apos; is under way. Wait for its end, or cancel it first.</source>
        <translation>“{0}”正在进行。请等待其结束，或先取消。</translation>
    </message>
    <message>
        <source>(assumed)</source>
        <translation>（假定）</translation>
    </message>
    <message>
        <source>, then</source>
        <translation>，然后</translation>
    </message>
    <message>
        <source>, with its normal along {0} at least partly</source>
        <translation>，其法线至少部分沿{0}</translation>
    </message>
    <message>
        <source>A fault of the program ended the solving.</source>
        <translation>程序故障使求解中止。</translation>
    </message>
    <message>
        <source>A fault of the program: this step cannot be shown.</source>
        <translation>程序故障：无法显示此步骤。</translation>
    </message>
    <message>
        <source>A point of &apos;{0}&apos; is not three numbers in mm. Pick it anew.</source>
        <translation>“{0}”有一个点不是三个 mm 数值。请重新选取。</translation>
    </message>
    <message>
        <source>Accepting</source>
        <translation>正在接受</translation>
    </message>
    <message>
        <source>After probing the blade could not be found: {0} {1}</source>
        <translation>探测后未能找到叶片：{0}{1}</translation>
    </message>
    <message>
        <source>After probing: {0} {1}</source>
        <translation>探测后：{0}{1}</translation>
    </message>
    <message>
        <source>Application Support</source>
        <translation>Application Support</translation>
    </message>
    <message>
        <source>Ball at the first place again, after all other scans</source>
        <translation>所有其他扫描之后，回到首个位置的标准球</translation>
    </message>
    <message>
        <source>Ball from the first to the closing scan</source>
        <translation>标准球从首次到收尾扫描</translation>
    </message>
    <message>
        <source>Ball in the first pose again, after all other poses</source>
        <translation>所有其他位姿之后，回到首个位姿的标准球</translation>
    </message>
    <message>
        <source>Ball in {F}</source>
        <translation>标准球在 {F} 中的位置</translation>
    </message>
    <message>
        <source>Ball in {F}, uncertainty (k = 2)</source>
        <translation>标准球在 {F} 中的不确定度（k = 2）</translation>
    </message>
    <message>
        <source>Ball in {M}</source>
        <translation>标准球在 {M} 中的位置</translation>
    </message>
    <message>
        <source>Ball seen</source>
        <translation>可见球面</translation>
    </message>
    <message>
        <source>Ball&apos;s diameter by the scans alone, certified {0} mm</source>
        <translation>仅由扫描得到的标准球直径，证书值{0} mm</translation>
    </message>
    <message>
        <source>Between the nodes of the grid; the fit does not see it. Delete it to probe it again.</source>
        <translation>在网格节点之间；拟合不使用它。删除它可重新探测。</translation>
    </message>
    <message>
        <source>Blade after probing, moved in its clamp</source>
        <translation>探测后叶片在夹具中的移动</translation>
    </message>
    <message>
        <source>Blade in {F}</source>
        <translation>叶片在 {F} 中的位姿</translation>
    </message>
    <message>
        <source>Blade in {M}</source>
        <translation>叶片在 {M} 中的位姿</translation>
    </message>
    <message>
        <source>Blade in {M}, by pairs</source>
        <translation>由点对得到的叶片在 {M} 中的位姿</translation>
    </message>
    <message>
        <source>Blade in {W}: normal error of the airfoil</source>
        <translation>{W} 中的叶片：叶身法向误差</translation>
    </message>
    <message>
        <source>Blade in {W}: points probed so far</source>
        <translation>{W} 中的叶片：目前已探测的点</translation>
    </message>
    <message>
        <source>Blade registered after clamping, RMS on the faces</source>
        <translation>装夹后配准的叶片，面上 RMS</translation>
    </message>
    <message>
        <source>By the faces</source>
        <translation>由各面</translation>
    </message>
    <message>
        <source>By the other faces</source>
        <translation>由其他面</translation>
    </message>
    <message>
        <source>By the other pairs</source>
        <translation>由其他点对</translation>
    </message>
    <message>
        <source>Choose one more face that holds the blade{0}.</source>
        <translation>请再选一个能约束叶片的面{0}。</translation>
    </message>
    <message>
        <source>Clamped blade, RMS on the faces</source>
        <translation>已装夹叶片，面上 RMS</translation>
    </message>
    <message>
        <source>Clamped blade, moved while it was probed</source>
        <translation>已装夹叶片，探测期间的移动</translation>
    </message>
    <message>
        <source>Clamped blade, two halves of the data apart</source>
        <translation>已装夹叶片，两半数据之差</translation>
    </message>
    <message>
        <source>Clamped blade, ± at its ends (k = 2)</source>
        <translation>已装夹叶片，两端的 ±（k = 2）</translation>
    </message>
    <message>
        <source>Comparing</source>
        <translation>正在比较</translation>
    </message>
    <message>
        <source>Compensation drawn</source>
        <translation>补偿量显示</translation>
    </message>
    <message>
        <source>Components</source>
        <translation>分量</translation>
    </message>
    <message>
        <source>Condition of the faces</source>
        <translation>各面的条件数</translation>
    </message>
    <message>
        <source>Condition of the fit</source>
        <translation>拟合的条件数</translation>
    </message>
    <message>
        <source>Cone</source>
        <translation>锥窝</translation>
    </message>
    <message>
        <source>Cone in {B}</source>
        <translation>锥窝在 {B} 中的位置</translation>
    </message>
    <message>
        <source>Covered</source>
        <translation>覆盖</translation>
    </message>
    <message>
        <source>Delete {0} (v = {1}) and acquire: it is probed again, points lost now: {2} of {3}.</source>
        <translation>请删除{0}（v = {1}）并采集：将重新探测它，目前缺失的点：{2}/{3}。</translation>
    </message>
    <message>
        <source>Different poses in the fit</source>
        <translation>拟合中的不同位姿</translation>
    </message>
    <message>
        <source>Distance</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Distances</source>
        <translation>距离</translation>
    </message>
    <message>
        <source>Enough for a pose; with one more pair the others can name a wrong one.</source>
        <translation>足以确定位姿；再有一个点对，其他点对就能指出错误的点对。</translation>
    </message>
    <message>
        <source>Error left, {0}</source>
        <translation>剩余误差，{0}</translation>
    </message>
    <message>
        <source>Error map</source>
        <translation>误差图</translation>
    </message>
    <message>
        <source>Exporting</source>
        <translation>正在导出</translation>
    </message>
    <message>
        <source>Faces</source>
        <translation>面</translation>
    </message>
    <message>
        <source>Faces to measure on</source>
        <translation>要测量的面</translation>
    </message>
    <message>
        <source>Flange tilt against vertical</source>
        <translation>法兰相对铅垂的倾角</translation>
    </message>
    <message>
        <source>Flange x in {B}</source>
        <translation>法兰在 {B} 中的 x</translation>
    </message>
    <message>
        <source>Flange y in {B}</source>
        <translation>法兰在 {B} 中的 y</translation>
    </message>
    <message>
        <source>Flange z in {B}</source>
        <translation>法兰在 {B} 中的 z</translation>
    </message>
    <message>
        <source>Frames at the wheel, apart from those of the probing</source>
        <translation>接触轮处的坐标系，与探测时所用者之差</translation>
    </message>
    <message>
        <source>Grinder</source>
        <translation>砂带磨床</translation>
    </message>
    <message>
        <source>Grinder {0}</source>
        <translation>{0}砂带磨床</translation>
    </message>
    <message>
        <source>Grinder {0}, least certain together: {1}.</source>
        <translation>{0}砂带磨床，组合起来最不确定的是：{1}。</translation>
    </message>
    <message>
        <source>Grinder {0}: held-out shaft mark, RMS</source>
        <translation>{0}砂带磨床：留出的轮轴标记，RMS</translation>
    </message>
    <message>
        <source>Grinder {0}: the reading of its head at the stop is left out, so a shift of the sensor&apos;s zero would not show later. Take it in again, or delete it and read it again.</source>
        <translation>{0}砂带磨床：其浮动头在挡块处的读数被排除，因此传感器零点以后的偏移将不会显示。请重新纳入，或删除后重新读取。</translation>
    </message>
    <message>
        <source>Head angle</source>
        <translation>浮动头角度</translation>
    </message>
    <message>
        <source>Head at its stop</source>
        <translation>浮动头在挡块处</translation>
    </message>
    <message>
        <source>Held-out ball by robot against scanner, RMS</source>
        <translation>留出标准球，机器人与扫描仪之差，RMS</translation>
    </message>
    <message>
        <source>Held-out ball, RMS</source>
        <translation>留出标准球，RMS</translation>
    </message>
    <message>
        <source>Held-out cone point, RMS</source>
        <translation>留出锥窝点，RMS</translation>
    </message>
    <message>
        <source>Held-out error, RMS</source>
        <translation>留出误差，RMS</translation>
    </message>
    <message>
        <source>How far the blade has moved since the rough step&apos;s scans of the same clamping</source>
        <translation>自粗定位步骤同一次装夹的扫描以来叶片的移动</translation>
    </message>
    <message>
        <source>It was not solved again. Solve it.</source>
        <translation>没有重新求解。请求解。</translation>
    </message>
    <message>
        <source>Its direction becomes known.</source>
        <translation>其方向将变为已知。</translation>
    </message>
    <message>
        <source>Its part of the airfoil is not measured now.</source>
        <translation>叶身的这一部分目前没有测量。</translation>
    </message>
    <message>
        <source>Keeping the cell&apos;s state</source>
        <translation>正在保存单元状态</translation>
    </message>
    <message>
        <source>Kind</source>
        <translation>类别</translation>
    </message>
    <message>
        <source>Largest distance between the poses of two halves of the scan, at both ends and in the middle</source>
        <translation>扫描两半所得位姿之间的最大距离，在两端和中部</translation>
    </message>
    <message>
        <source>Largest distance of a pair from where the faces put it</source>
        <translation>点对与各面所定位置的最大距离</translation>
    </message>
    <message>
        <source>Largest distance of a pair from where the other pairs put it</source>
        <translation>点对与其他点对所定位置的最大距离</translation>
    </message>
    <message>
        <source>Least certain together: {0}.</source>
        <translation>组合起来最不确定的是：{0}。</translation>
    </message>
    <message>
        <source>Leave-one-out</source>
        <translation>留一法</translation>
    </message>
    <message>
        <source>Leave-one-out error, RMS</source>
        <translation>留一法误差，RMS</translation>
    </message>
    <message>
        <source>Library</source>
        <translation>Library</translation>
    </message>
    <message>
        <source>Look at {0} and its angle first; repeat it or add touches.</source>
        <translation>请先查看{0}及其角度；重做它或增加触测。</translation>
    </message>
    <message>
        <source>Look at {0} first; repeat it or add touches.</source>
        <translation>请先查看{0}；重做它或增加触测。</translation>
    </message>
    <message>
        <source>Looks at the first place again.</source>
        <translation>重新查看首个位置。</translation>
    </message>
    <message>
        <source>Mean</source>
        <translation>平均</translation>
    </message>
    <message>
        <source>Mean distance of {0} from where the other faces put it</source>
        <translation>{0}与其他面所定位置的平均距离</translation>
    </message>
    <message>
        <source>Middle of the balls in {B}, uncertainty (k = 2)</source>
        <translation>各球中部在 {B} 中的不确定度（k = 2）</translation>
    </message>
    <message>
        <source>No cell is connected, so no samples can be taken.</source>
        <translation>没有连接单元，因此无法采集样本。</translation>
    </message>
    <message>
        <source>No face is chosen. Click on at least three faces of the CAD model.</source>
        <translation>没有选择面。请在 CAD 模型上至少点击三个面。</translation>
    </message>
    <message>
        <source>No session is open. Begin one or open one first.</source>
        <translation>没有打开会话。请先新建或打开一个。</translation>
    </message>
    <message>
        <source>Nobody is named who works. Enter a name: it is kept with every decision.</source>
        <translation>没有填写操作者。请输入姓名：它会与每个决定一起保存。</translation>
    </message>
    <message>
        <source>Noise of a ball centre, each coordinate</source>
        <translation>球心的噪声，每个坐标</translation>
    </message>
    <message>
        <source>Noise of a sample (1 sigma)</source>
        <translation>单个样本的噪声（1 sigma）</translation>
    </message>
    <message>
        <source>Noise on the ball</source>
        <translation>标准球上的噪声</translation>
    </message>
    <message>
        <source>Normal error at points that the fit has not seen {0} mm RMS.</source>
        <translation>拟合未使用的点上的法向误差：{0} mm RMS。</translation>
    </message>
    <message>
        <source>Normal error, RMS</source>
        <translation>法向误差，RMS</translation>
    </message>
    <message>
        <source>Normal error, largest</source>
        <translation>法向误差，最大</translation>
    </message>
    <message>
        <source>Normal error, smallest</source>
        <translation>法向误差，最小</translation>
    </message>
    <message>
        <source>Of an earlier clamping, or probed with other frames; it does not count any more.</source>
        <translation>属于先前的装夹，或以其他坐标系探测；不再有效。</translation>
    </message>
    <message>
        <source>Off the model</source>
        <translation>偏离模型</translation>
    </message>
    <message>
        <source>On the faces</source>
        <translation>在面上</translation>
    </message>
    <message>
        <source>One more scan adds most with the flange at x {0} mm, y {1} mm, z {2} mm in {B}, turned by Z {3} deg, Y&apos; {4} deg, X&apos;&apos; {5} deg.</source>
        <translation>再扫描一次，法兰在 {B} 中位于 x {0} mm、y {1} mm、z {2} mm，转角 Z {3} deg、Y&apos; {4} deg、X&apos;&apos; {5} deg 时收益最大。</translation>
    </message>
    <message>
        <source>One more scan adds most with the stage at x {0} mm, y {1} mm, z {2} mm, turned by {3} deg.</source>
        <translation>再扫描一次，位移台位于 x {0} mm、y {1} mm、z {2} mm，转角{3} deg 时收益最大。</translation>
    </message>
    <message>
        <source>One more touch of the cone adds most with the flange tilted by {0} deg towards {1} deg in {B}, counted from x to y.</source>
        <translation>再触测一次锥窝，法兰在 {B} 中朝{1} deg 方向（从 x 向 y 计）倾斜{0} deg 时收益最大。</translation>
    </message>
    <message>
        <source>One more touch of the shaft of grinder {0} adds most at a head angle of {1} deg.</source>
        <translation>再触测一次{0}砂带磨床的轮轴，浮动头角度为{1} deg 时收益最大。</translation>
    </message>
    <message>
        <source>Only &apos;{0}&apos; is a witness of something: a pose like it would check it.</source>
        <translation>只有“{0}”能见证某个量：增加一个与它相似的位姿即可检验它。</translation>
    </message>
    <message>
        <source>Only {0} is a witness of something, so a mistake in it would not show. Add touches like it.</source>
        <translation>只有{0}能见证某个量，因此其中的错误不会显示。请增加与它相似的触测。</translation>
    </message>
    <message>
        <source>Opening the session</source>
        <translation>正在打开会话</translation>
    </message>
    <message>
        <source>Orientations</source>
        <translation>姿态</translation>
    </message>
    <message>
        <source>Origin of {M} in {B},</source>
        <translation>{M} 的原点在 {B} 中的位置</translation>
    </message>
    <message>
        <source>Other scans were taken after this closing scan, so it no longer closes the series.</source>
        <translation>在此收尾扫描之后又采集了其他扫描，因此它不再是系列的收尾。</translation>
    </message>
    <message>
        <source>Pair &apos;{0}&apos; is {1} mm off where the faces of the blade put it, the limit is {2} mm. Pick it again, or leave it out.</source>
        <translation>点对“{0}”与叶片各面所定位置相差{1} mm，限值为{2} mm。请重新选取，或将其排除。</translation>
    </message>
    <message>
        <source>Pair &apos;{0}&apos; stands out: pick it again, or leave it out.</source>
        <translation>点对“{0}”异常：请重新选取，或将其排除。</translation>
    </message>
    <message>
        <source>Pair {0} has no name and points. Pick it anew.</source>
        <translation>点对{0}没有名称和点。请重新选取。</translation>
    </message>
    <message>
        <source>Pairs</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>Path shown</source>
        <translation>显示的路径</translation>
    </message>
    <message>
        <source>Pick &apos;{0}&apos; on the {1} too.</source>
        <translation>请在{1}上也选取“{0}”。</translation>
    </message>
    <message>
        <source>Pick a fourth pair, away from the others.</source>
        <translation>请选取第四个点对，远离其他点对。</translation>
    </message>
    <message>
        <source>Pick {0} more: the same point on the scan and on the CAD model.</source>
        <translation>请再选取{0}个：在扫描和 CAD 模型上选同一点。</translation>
    </message>
    <message>
        <source>Point carried to {B} as far out as the balls, uncertainty (k = 2)</source>
        <translation>变换到 {B} 的点，远至各球处，不确定度（k = 2）</translation>
    </message>
    <message>
        <source>Points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>Points missing</source>
        <translation>缺失的点</translation>
    </message>
    <message>
        <source>Points rejected</source>
        <translation>剔除的点</translation>
    </message>
    <message>
        <source>Points used</source>
        <translation>使用的点</translation>
    </message>
    <message>
        <source>Predicted</source>
        <translation>预测</translation>
    </message>
    <message>
        <source>Probe {0} {1} at v = {2}.</source>
        <translation>请探测{0} {1}，v = {2}。</translation>
    </message>
    <message>
        <source>Program {0}</source>
        <translation>程序{0}</translation>
    </message>
    <message>
        <source>Program {0}: {1} contacts are left out, nothing was measured there.</source>
        <translation>程序{0}：去掉了{1}个接触点，那里没有测量。</translation>
    </message>
    <message>
        <source>RMS distance of the scan from the faces</source>
        <translation>扫描到各面距离的 RMS</translation>
    </message>
    <message>
        <source>RMS of its prediction&apos;s error</source>
        <translation>其预测误差的 RMS</translation>
    </message>
    <message>
        <source>RMS of the normal error</source>
        <translation>法向误差的 RMS</translation>
    </message>
    <message>
        <source>Redo</source>
        <translation>需重做</translation>
    </message>
    <message>
        <source>Rejected points</source>
        <translation>剔除的点</translation>
    </message>
    <message>
        <source>Residuals</source>
        <translation>残差</translation>
    </message>
    <message>
        <source>Residuals of the fit, RMS</source>
        <translation>拟合残差，RMS</translation>
    </message>
    <message>
        <source>Roaming</source>
        <translation>Roaming</translation>
    </message>
    <message>
        <source>Robot off scanner</source>
        <translation>机器人与扫描仪之差</translation>
    </message>
    <message>
        <source>Robot programs, read back</source>
        <translation>机器人程序，回读检查</translation>
    </message>
    <message>
        <source>Rotary axis in {M}, direction {0}</source>
        <translation>旋转轴在 {M} 中，方向{0}</translation>
    </message>
    <message>
        <source>Rotary axis in {M}, point nearest to the origin,</source>
        <translation>旋转轴在 {M} 中离原点最近的点</translation>
    </message>
    <message>
        <source>Scale of stage axis {0}, moved per commanded</source>
        <translation>位移台轴{0}的比例系数，实际移动比指令</translation>
    </message>
    <message>
        <source>Scan &apos;{0}&apos; as the scanner sees it</source>
        <translation>扫描仪看到的扫描“{0}”</translation>
    </message>
    <message>
        <source>Scan &apos;{0}&apos; next: of the missing poses it adds most.</source>
        <translation>下一个扫描“{0}”：在缺少的位姿中收益最大。</translation>
    </message>
    <message>
        <source>Scan &apos;{0}&apos; next: of the missing scans it adds most.</source>
        <translation>下一个扫描“{0}”：在缺少的扫描中收益最大。</translation>
    </message>
    <message>
        <source>Scan &apos;{0}&apos; next: stage axis {1} has not moved yet.</source>
        <translation>下一个扫描“{0}”：位移台轴{1}还没有移动过。</translation>
    </message>
    <message>
        <source>Scan of the blade</source>
        <translation>叶片的扫描</translation>
    </message>
    <message>
        <source>Scan on the CAD model, by face</source>
        <translation>CAD 模型上的扫描，按面着色</translation>
    </message>
    <message>
        <source>Scan on the CAD model, by signed distance</source>
        <translation>CAD 模型上的扫描，按带符号距离着色</translation>
    </message>
    <message>
        <source>Scan that lies on the CAD model</source>
        <translation>落在 CAD 模型上的扫描</translation>
    </message>
    <message>
        <source>Scanned point in {M}, uncertainty (k = 2), worst planned scan</source>
        <translation>扫描点在 {M} 中的不确定度（k = 2），最差的计划扫描</translation>
    </message>
    <message>
        <source>Scanner on its stage, as planned</source>
        <translation>位移台上的扫描仪（计划）</translation>
    </message>
    <message>
        <source>Scanner {S} in {M} at stage zero, turn</source>
        <translation>位移台零位时扫描仪 {S} 在 {M} 中的转角</translation>
    </message>
    <message>
        <source>Scatter</source>
        <translation>离散度</translation>
    </message>
    <message>
        <source>Scatter of a point (1 sigma)</source>
        <translation>单点离散度（1 sigma）</translation>
    </message>
    <message>
        <source>Scatter of the robot, each coordinate</source>
        <translation>机器人的离散度，每个坐标</translation>
    </message>
    <message>
        <source>Section at v</source>
        <translation>截面位置 v</translation>
    </message>
    <message>
        <source>Section at v = {0} ({1})</source>
        <translation>截面 v = {0}（{1}）</translation>
    </message>
    <message>
        <source>Shaft {0}</source>
        <translation>{0}轮轴</translation>
    </message>
    <message>
        <source>Simulated cell</source>
        <translation>模拟单元</translation>
    </message>
    <message>
        <source>Solving</source>
        <translation>正在求解</translation>
    </message>
    <message>
        <source>Something outside the program failed: {0}. What was kept before is whole.</source>
        <translation>程序之外发生错误：{0}。之前保存的内容完好。</translation>
    </message>
    <message>
        <source>Squareness of axes {0}, angle less 90 deg</source>
        <translation>轴{0}的垂直度，角度减 90 deg</translation>
    </message>
    <message>
        <source>Stage axis {0} has not moved: its direction and scale are assumed, not measured.</source>
        <translation>位移台轴{0}没有移动过：其方向和比例系数是假定的，不是测得的。</translation>
    </message>
    <message>
        <source>Stage turn</source>
        <translation>位移台转角</translation>
    </message>
    <message>
        <source>Stage x</source>
        <translation>位移台 x</translation>
    </message>
    <message>
        <source>Stage y</source>
        <translation>位移台 y</translation>
    </message>
    <message>
        <source>Stage z</source>
        <translation>位移台 z</translation>
    </message>
    <message>
        <source>Still to be picked on the {0}.</source>
        <translation>尚待在{0}上选取。</translation>
    </message>
    <message>
        <source>Stylus tip in {F}</source>
        <translation>测针针尖在 {F} 中的位置</translation>
    </message>
    <message>
        <source>Stylus tip, uncertainty (k = 2)</source>
        <translation>测针针尖，不确定度（k = 2）</translation>
    </message>
    <message>
        <source>Stylus, condition of the fit</source>
        <translation>测针，拟合的条件数</translation>
    </message>
    <message>
        <source>Stylus, largest turn between two touches</source>
        <translation>测针，两次触测之间的最大转角</translation>
    </message>
    <message>
        <source>Stylus, least certain together: {0}.</source>
        <translation>测针，组合起来最不确定的是：{0}。</translation>
    </message>
    <message>
        <source>Stylus, noise of a touch, each coordinate</source>
        <translation>测针，触测噪声，每个坐标</translation>
    </message>
    <message>
        <source>Stylus, residuals of the fit, RMS</source>
        <translation>测针，拟合残差，RMS</translation>
    </message>
    <message>
        <source>Take cone touch {0} next: of the missing ones it adds most.</source>
        <translation>下一步做锥窝触测{0}：在缺少的触测中收益最大。</translation>
    </message>
    <message>
        <source>Taking samples</source>
        <translation>正在采集样本</translation>
    </message>
    <message>
        <source>The automatic search finds the blade near these pairs: use it, or pick the pairs wider apart.</source>
        <translation>自动搜索在这些点对附近找到了叶片：请使用它，或把点对选得更分散。</translation>
    </message>
    <message>
        <source>The automatic search finds the blade where pair &apos;{0}&apos; is {1} mm off: pick it again, or leave it out.</source>
        <translation>自动搜索找到的叶片位置与点对“{0}”相差{1} mm：请重新选取，或将其排除。</translation>
    </message>
    <message>
        <source>The ball is {0} mm from where the first scan saw it; the limit is {1} mm.</source>
        <translation>标准球与首次扫描所见位置相差{0} mm；限值为{1} mm。</translation>
    </message>
    <message>
        <source>The ball on the flange, as planned</source>
        <translation>法兰上的标准球（计划）</translation>
    </message>
    <message>
        <source>The ball on the flange, seen in many robot poses</source>
        <translation>法兰上的标准球，在多个机器人位姿下所见</translation>
    </message>
    <message>
        <source>The blade as it is to be scanned</source>
        <translation>要扫描的叶片</translation>
    </message>
    <message>
        <source>The blade was clamped anew after the rough step, so nothing shows whether it has slipped.</source>
        <translation>叶片在粗定位步骤之后重新装夹过，因此无法说明它是否滑动。</translation>
    </message>
    <message>
        <source>The chosen faces leave the blade free to move: {0} in the CAD frame. Choose one more face that holds it{1}.</source>
        <translation>所选面使叶片仍可自由移动：CAD 坐标系中的{0}。请再选一个能约束它的面{1}。</translation>
    </message>
    <message>
        <source>The engine has crashed (exit code {0}).
{1}</source>
        <translation>引擎已崩溃（退出代码{0}）。
{1}</translation>
    </message>
    <message>
        <source>The engine has ended by itself (exit code {0}).</source>
        <translation>引擎已自行结束（退出代码{0}）。</translation>
    </message>
    <message>
        <source>The error of {0} predicted from the others</source>
        <translation>由其他数据预测的{0}的误差</translation>
    </message>
    <message>
        <source>The error of {0}, which the others contradict,</source>
        <translation>与其他数据矛盾的{0}的误差</translation>
    </message>
    <message>
        <source>The error surface has to be solved again first.</source>
        <translation>误差曲面须先重新求解。</translation>
    </message>
    <message>
        <source>The error surface is not accepted, so nothing is exported: {0}</source>
        <translation>误差曲面未被接受，因此不导出任何内容：{0}</translation>
    </message>
    <message>
        <source>The head at its stop: read again around the probing, so that a shift of the sensor&apos;s zero shows.</source>
        <translation>挡块处的浮动头：在探测前后再次读取，以便看出传感器零点的偏移。</translation>
    </message>
    <message>
        <source>The held-out error of {0}, which the others contradict,</source>
        <translation>与其他数据矛盾的{0}的留出误差</translation>
    </message>
    <message>
        <source>The monitor of the devices has ended.
{0}</source>
        <translation>设备监视已结束。
{0}</translation>
    </message>
    <message>
        <source>The pair with the largest distance is &apos;{0}&apos;. Pick the pairs again, at clear corners.</source>
        <translation>距离最大的点对是“{0}”。请在清晰的角点处重新选取点对。</translation>
    </message>
    <message>
        <source>The pairs are no list. Pick them anew.</source>
        <translation>点对不是列表。请重新选取。</translation>
    </message>
    <message>
        <source>The pose of the pairs is not confirmed by the faces. {0} ({1})</source>
        <translation>点对所得的位姿没有得到各面的证实。{0}（{1}）</translation>
    </message>
    <message>
        <source>The result of {0} was rejected.</source>
        <translation>{0}的结果被拒绝。</translation>
    </message>
    <message>
        <source>The rotary axis has not moved: scans at another angle cannot be placed.</source>
        <translation>旋转轴没有移动过：无法放置其他角度的扫描。</translation>
    </message>
    <message>
        <source>The rough step knows the methods &apos;{0}&apos; and &apos;{1}&apos;, found {2}.</source>
        <translation>粗定位步骤的方法有“{0}”和“{1}”，现为{2}。</translation>
    </message>
    <message>
        <source>The samples changed since it was solved: {0} no longer used, {1} new.</source>
        <translation>求解后样本已改变：不再使用{0}个，新增{1}个。</translation>
    </message>
    <message>
        <source>The session is open to look at only. Open it to go on with it.</source>
        <translation>会话以只读方式打开。要继续工作，请正常打开。</translation>
    </message>
    <message>
        <source>The setting &apos;{0}&apos; changed since it was solved.</source>
        <translation>求解后设置“{0}”已改变。</translation>
    </message>
    <message>
        <source>The solving was ended early. Solve again.</source>
        <translation>求解提前结束。请重新求解。</translation>
    </message>
    <message>
        <source>The uncertainty is that of scanner noise and of the base step; it does not include the robot&apos;s own error in its reported pose.</source>
        <translation>该不确定度来自扫描仪噪声和基坐标系步骤；不包含机器人所报位姿自身的误差。</translation>
    </message>
    <message>
        <source>There are no programs.</source>
        <translation>没有程序。</translation>
    </message>
    <message>
        <source>There is no fault &apos;{0}&apos; to simulate; there are: {1}.</source>
        <translation>没有可模拟的故障“{0}”；可用的有：{1}。</translation>
    </message>
    <message>
        <source>There is no simulated cell to let something go wrong in.</source>
        <translation>没有可以让其出错的模拟单元。</translation>
    </message>
    <message>
        <source>There is no step &apos;{0}&apos;.</source>
        <translation>没有步骤“{0}”。</translation>
    </message>
    <message>
        <source>There is no such pair any more.</source>
        <translation>该点对已不存在。</translation>
    </message>
    <message>
        <source>There is nothing to do again.</source>
        <translation>没有可重做的操作。</translation>
    </message>
    <message>
        <source>There is nothing to undo.</source>
        <translation>没有可撤销的操作。</translation>
    </message>
    <message>
        <source>To do</source>
        <translation>待办</translation>
    </message>
    <message>
        <source>Touch the shaft of grinder {0} at {1} deg next.</source>
        <translation>下一步在{1} deg 处触测{0}砂带磨床的轮轴。</translation>
    </message>
    <message>
        <source>Turn of {M} in {B}, uncertainty (k = 2)</source>
        <translation>{M} 在 {B} 中的转角，不确定度（k = 2）</translation>
    </message>
    <message>
        <source>Two halves</source>
        <translation>两半</translation>
    </message>
    <message>
        <source>Two pairs are called &apos;{0}&apos;. Rename one of them.</source>
        <translation>有两个点对都叫“{0}”。请重命名其中一个。</translation>
    </message>
    <message>
        <source>Type</source>
        <translation>类型</translation>
    </message>
    <message>
        <source>Uncertainty of a point carried to {B} (k = 2): from {0} to {1} mm.</source>
        <translation>变换到 {B} 的点的不确定度（k = 2）：从{0}变为{1} mm。</translation>
    </message>
    <message>
        <source>Uncertainty of a scanned point (k = 2): from {0} to {1} µm.</source>
        <translation>扫描点的不确定度（k = 2）：从{0}变为{1} µm。</translation>
    </message>
    <message>
        <source>Uncertainty of the stylus tip (k = 2): from {0} to {1} mm.</source>
        <translation>测针针尖的不确定度（k = 2）：从{0}变为{1} mm。</translation>
    </message>
    <message>
        <source>Uncertainty of the wheel of grinder {0} (k = 2): from {1} to {2} mm.</source>
        <translation>{0}砂带磨床接触轮的不确定度（k = 2）：从{1}变为{2} mm。</translation>
    </message>
    <message>
        <source>Uncertainty of the {0} (z = {1} mm in {W}), k = 2</source>
        <translation>{0}的不确定度（{W} 中 z = {1} mm），k = 2</translation>
    </message>
    <message>
        <source>Wheel at the head&apos;s stop, moved since the tool step</source>
        <translation>浮动头挡块处的接触轮，自工具步骤以来的移动</translation>
    </message>
    <message>
        <source>[Errno {0}] {1}: {2}</source>
        <translation>[Errno {0}] {1}：{2}</translation>
    </message>
    <message>
        <source>a wrong pair is then named by the others</source>
        <translation>其他点对便能指出错误的点对</translation>
    </message>
    <message>
        <source>all faces</source>
        <translation>所有面</translation>
    </message>
    <message>
        <source>and</source>
        <translation>和</translation>
    </message>
    <message>
        <source>and {0} deg</source>
        <translation>和{0} deg</translation>
    </message>
    <message>
        <source>around the probing</source>
        <translation>探测前后</translation>
    </message>
    <message>
        <source>attempt to write a readonly database</source>
        <translation>数据库为只读</translation>
    </message>
    <message>
        <source>automatic</source>
        <translation>自动</translation>
    </message>
    <message>
        <source>ball by robot less by scanner in {B}, mm</source>
        <translation>{B} 中机器人所得球心减扫描仪所得球心，mm</translation>
    </message>
    <message>
        <source>ball by robot off ball by scanner, mm</source>
        <translation>机器人所得球心与扫描仪所得球心之差，mm</translation>
    </message>
    <message>
        <source>ball by the scanner</source>
        <translation>扫描仪所得的球</translation>
    </message>
    <message>
        <source>ball less model in {M}, µm</source>
        <translation>{M} 中球心减模型，µm</translation>
    </message>
    <message>
        <source>ball_covariance_mm2[{0}]: a covariance must be positive definite, its smallest variance is {1} mm^2.</source>
        <translation>ball_covariance_mm2[{0}]：协方差必须正定，其最小方差为{1} mm^2。</translation>
    </message>
    <message>
        <source>base_from_tool ({0})</source>
        <translation>base_from_tool（{0}）</translation>
    </message>
    <message>
        <source>beltcal</source>
        <translation>beltcal</translation>
    </message>
    <message>
        <source>beltcal engine</source>
        <translation>beltcal engine</translation>
    </message>
    <message>
        <source>blade as planned</source>
        <translation>计划的叶片</translation>
    </message>
    <message>
        <source>blade mesh</source>
        <translation>叶片网格</translation>
    </message>
    <message>
        <source>by the faces</source>
        <translation>由各面</translation>
    </message>
    <message>
        <source>by the other faces</source>
        <translation>由其他面</translation>
    </message>
    <message>
        <source>by the other pairs</source>
        <translation>由其他点对</translation>
    </message>
    <message>
        <source>cell moved</source>
        <translation>单元已移动</translation>
    </message>
    <message>
        <source>check line</source>
        <translation>检验线</translation>
    </message>
    <message>
        <source>check line {0}</source>
        <translation>检验线{0}</translation>
    </message>
    <message>
        <source>chosen faces</source>
        <translation>所选面</translation>
    </message>
    <message>
        <source>compare</source>
        <translation>比较</translation>
    </message>
    <message>
        <source>compensated, ± (k = 2)</source>
        <translation>补偿后，±（k = 2）</translation>
    </message>
    <message>
        <source>compensation drawn x{0}</source>
        <translation>补偿量放大{0}倍显示</translation>
    </message>
    <message>
        <source>cone {0}</source>
        <translation>锥窝{0}</translation>
    </message>
    <message>
        <source>connected</source>
        <translation>已连接</translation>
    </message>
    <message>
        <source>connecting the devices</source>
        <translation>正在连接设备</translation>
    </message>
    <message>
        <source>contact wheel and its head axis</source>
        <translation>接触轮及浮动头轴</translation>
    </message>
    <message>
        <source>contacts</source>
        <translation>接触点</translation>
    </message>
    <message>
        <source>crashed</source>
        <translation>已崩溃</translation>
    </message>
    <message>
        <source>dX in {M}</source>
        <translation>{M} 中的 dX</translation>
    </message>
    <message>
        <source>dY in {M}</source>
        <translation>{M} 中的 dY</translation>
    </message>
    <message>
        <source>dZ in {M}</source>
        <translation>{M} 中的 dZ</translation>
    </message>
    <message>
        <source>database disk image is malformed</source>
        <translation>数据库文件已损坏</translation>
    </message>
    <message>
        <source>database is locked</source>
        <translation>数据库被占用</translation>
    </message>
    <message>
        <source>disk I/O error</source>
        <translation>磁盘读写错误</translation>
    </message>
    <message>
        <source>distance from the prediction by all others, mm</source>
        <translation>与由其他全部数据所得预测的距离，mm</translation>
    </message>
    <message>
        <source>distance from the prediction by all others, µm</source>
        <translation>与由其他全部数据所得预测的距离，µm</translation>
    </message>
    <message>
        <source>distance of the ball from the model, µm</source>
        <translation>标准球与模型的距离，µm</translation>
    </message>
    <message>
        <source>distance, mm</source>
        <translation>距离，mm</translation>
    </message>
    <message>
        <source>edge plate</source>
        <translation>缘板</translation>
    </message>
    <message>
        <source>edit</source>
        <translation>编辑</translation>
    </message>
    <message>
        <source>engine</source>
        <translation>引擎</translation>
    </message>
    <message>
        <source>engine events</source>
        <translation>engine events</translation>
    </message>
    <message>
        <source>engine monitor</source>
        <translation>engine monitor</translation>
    </message>
    <message>
        <source>engine reader</source>
        <translation>engine reader</translation>
    </message>
    <message>
        <source>engine work</source>
        <translation>engine work</translation>
    </message>
    <message>
        <source>error of the prediction, µm</source>
        <translation>预测误差，µm</translation>
    </message>
    <message>
        <source>error surface</source>
        <translation>误差曲面</translation>
    </message>
    <message>
        <source>exported</source>
        <translation>已导出</translation>
    </message>
    <message>
        <source>exported to {0}</source>
        <translation>已导出到{0}</translation>
    </message>
    <message>
        <source>extra {0}</source>
        <translation>附加{0}</translation>
    </message>
    <message>
        <source>face</source>
        <translation>面</translation>
    </message>
    <message>
        <source>fault</source>
        <translation>故障</translation>
    </message>
    <message>
        <source>file is not a database</source>
        <translation>该文件不是数据库</translation>
    </message>
    <message>
        <source>filter boxes</source>
        <translation>过滤框</translation>
    </message>
    <message>
        <source>finish it</source>
        <translation>请完成</translation>
    </message>
    <message>
        <source>fitted ball {0} mm RMS, nothing held out</source>
        <translation>标准球拟合{0} mm RMS，没有留出任何数据</translation>
    </message>
    <message>
        <source>fitted stylus {0} mm RMS</source>
        <translation>测针拟合{0} mm RMS</translation>
    </message>
    <message>
        <source>found automatically</source>
        <translation>自动找到</translation>
    </message>
    <message>
        <source>found by pairs</source>
        <translation>由点对找到</translation>
    </message>
    <message>
        <source>grinder</source>
        <translation>砂带磨床</translation>
    </message>
    <message>
        <source>grinder fine</source>
        <translation>精磨砂带磨床</translation>
    </message>
    <message>
        <source>grinder rough</source>
        <translation>粗磨砂带磨床</translation>
    </message>
    <message>
        <source>grinder {0}</source>
        <translation>{0}砂带磨床</translation>
    </message>
    <message>
        <source>grinder {0} angle</source>
        <translation>{0}砂带磨床浮动头角度</translation>
    </message>
    <message>
        <source>grinder {0} force</source>
        <translation>{0}砂带磨床接触力</translation>
    </message>
    <message>
        <source>grinder {0}: contact_side must be 1 or -1, found {1}.</source>
        <translation>{0}砂带磨床：contact_side 必须为 1 或 -1，现为{1}。</translation>
    </message>
    <message>
        <source>grinder {0}: head at its stop</source>
        <translation>{0}砂带磨床：浮动头在挡块处</translation>
    </message>
    <message>
        <source>grinder {0}: shaft at {1} degrees</source>
        <translation>{0}砂带磨床：{1}度处的轮轴</translation>
    </message>
    <message>
        <source>hardly any points; those in its box are as thin as stray points</source>
        <translation>几乎没有点；其框内的点与杂散点一样稀疏</translation>
    </message>
    <message>
        <source>head angle, deg</source>
        <translation>浮动头角度，deg</translation>
    </message>
    <message>
        <source>head axis {0}</source>
        <translation>{0}浮动头轴</translation>
    </message>
    <message>
        <source>head radius ({0})</source>
        <translation>浮动头半径（{0}）</translation>
    </message>
    <message>
        <source>held out</source>
        <translation>留出</translation>
    </message>
    <message>
        <source>held-out RMS</source>
        <translation>留出 RMS</translation>
    </message>
    <message>
        <source>held-out RMS (cone)</source>
        <translation>留出 RMS（锥窝）</translation>
    </message>
    <message>
        <source>held-out RMS ({0})</source>
        <translation>留出 RMS（{0}）</translation>
    </message>
    <message>
        <source>held-out ball {0} mm RMS</source>
        <translation>留出标准球{0} mm RMS</translation>
    </message>
    <message>
        <source>held-out error {0} mm RMS</source>
        <translation>留出误差{0} mm RMS</translation>
    </message>
    <message>
        <source>held-out shaft mark {0} mm RMS</source>
        <translation>留出轮轴标记{0} mm RMS</translation>
    </message>
    <message>
        <source>held-out, two halves</source>
        <translation>留出，两半</translation>
    </message>
    <message>
        <source>in a hole of the measured patch</source>
        <translation>测量区域的空洞中</translation>
    </message>
    <message>
        <source>in the fit</source>
        <translation>拟合中</translation>
    </message>
    <message>
        <source>inches</source>
        <translation>英寸</translation>
    </message>
    <message>
        <source>inlier</source>
        <translation>inlier</translation>
    </message>
    <message>
        <source>inputs</source>
        <translation>inputs</translation>
    </message>
    <message>
        <source>interpolate</source>
        <translation>interpolate</translation>
    </message>
    <message>
        <source>intervals: expected at least 1 in u and v, found {0}.</source>
        <translation>intervals：u 和 v 方向应至少为 1，现为{0}。</translation>
    </message>
    <message>
        <source>it answers, but its values stand still. Wait, or connect it again.</source>
        <translation>有应答，但其数值不变。请等待，或重新连接。</translation>
    </message>
    <message>
        <source>it has no boundary</source>
        <translation>它没有边界</translation>
    </message>
    <message>
        <source>it only reports its pose and cannot be moved from here. Move it by its own panel.</source>
        <translation>它只报告自己的位姿，不能从这里移动。请用它自己的操作面板移动。</translation>
    </message>
    <message>
        <source>it was declined: {0} Begin again to go on.</source>
        <translation>被拒绝执行：{0}请重新开始以继续。</translation>
    </message>
    <message>
        <source>its border was left out: ghosts or burrs there</source>
        <translation>其边缘已去掉：那里有虚点或毛刺</translation>
    </message>
    <message>
        <source>its boundary encloses no area</source>
        <translation>其边界没有围成面积</translation>
    </message>
    <message>
        <source>its boundary encloses {0} mm², but its area is {1} mm²</source>
        <translation>其边界围成{0} mm²，而其面积为{1} mm²</translation>
    </message>
    <message>
        <source>its boundary goes around the axis more than once</source>
        <translation>其边界绕轴超过一周</translation>
    </message>
    <message>
        <source>its points lie {0} mm off the surface that the other faces give</source>
        <translation>其点偏离其他面所定的表面{0} mm</translation>
    </message>
    <message>
        <source>joint {0}</source>
        <translation>关节{0}</translation>
    </message>
    <message>
        <source>kept out of the fit</source>
        <translation>留在拟合之外</translation>
    </message>
    <message>
        <source>largest difference</source>
        <translation>最大差别</translation>
    </message>
    <message>
        <source>largest difference of a contact</source>
        <translation>接触点的最大差别</translation>
    </message>
    <message>
        <source>largest speed</source>
        <translation>最大速度</translation>
    </message>
    <message>
        <source>largest turn</source>
        <translation>最大转角</translation>
    </message>
    <message>
        <source>leave-one-out RMS</source>
        <translation>留一法 RMS</translation>
    </message>
    <message>
        <source>left out</source>
        <translation>已排除</translation>
    </message>
    <message>
        <source>limit</source>
        <translation>限值</translation>
    </message>
    <message>
        <source>limit of any</source>
        <translation>单个的限值</translation>
    </message>
    <message>
        <source>limit of the held-out RMS</source>
        <translation>留出 RMS 的限值</translation>
    </message>
    <message>
        <source>limit where the others contradict</source>
        <translation>其他数据矛盾时的限值</translation>
    </message>
    <message>
        <source>limits</source>
        <translation>limits</translation>
    </message>
    <message>
        <source>line</source>
        <translation>线</translation>
    </message>
    <message>
        <source>line that is probed next</source>
        <translation>接下来探测的线</translation>
    </message>
    <message>
        <source>line {0}</source>
        <translation>线{0}</translation>
    </message>
    <message>
        <source>line {0} of {1}</source>
        <translation>线{0}/{1}</translation>
    </message>
    <message>
        <source>lines</source>
        <translation>条线</translation>
    </message>
    <message>
        <source>lines to come</source>
        <translation>待探测的线</translation>
    </message>
    <message>
        <source>longitudinal</source>
        <translation>纵向</translation>
    </message>
    <message>
        <source>look like degrees: times pi/180 they fit. Give rad.</source>
        <translation>看起来单位是度：乘以 pi/180 后吻合。请用 rad 给出。</translation>
    </message>
    <message>
        <source>look like rad given as degrees (converted twice): times 180/pi they fit.</source>
        <translation>看起来是按度给出的 rad（转换了两次）：乘以 180/pi 后吻合。</translation>
    </message>
    <message>
        <source>looking for parallel faces</source>
        <translation>正在寻找平行的面</translation>
    </message>
    <message>
        <source>looking for the ball in scan {0} of {1}</source>
        <translation>正在扫描{0}/{1}中寻找标准球</translation>
    </message>
    <message>
        <source>looking for the fixture&apos;s planes</source>
        <translation>正在寻找夹具的平面</translation>
    </message>
    <message>
        <source>lower end</source>
        <translation>下端</translation>
    </message>
    <message>
        <source>maps</source>
        <translation>maps</translation>
    </message>
    <message>
        <source>mean signed distance, µm</source>
        <translation>平均带符号距离，µm</translation>
    </message>
    <message>
        <source>measured</source>
        <translation>测得</translation>
    </message>
    <message>
        <source>mesh</source>
        <translation>mesh</translation>
    </message>
    <message>
        <source>method</source>
        <translation>方法</translation>
    </message>
    <message>
        <source>metres</source>
        <translation>米</translation>
    </message>
    <message>
        <source>middle</source>
        <translation>中部</translation>
    </message>
    <message>
        <source>missing</source>
        <translation>缺失</translation>
    </message>
    <message>
        <source>mode: expected &apos;interpolate&apos; or &apos;smooth&apos;, found &apos;{0}&apos;.</source>
        <translation>mode：应为“interpolate”或“smooth”，现为“{0}”。</translation>
    </message>
    <message>
        <source>motion</source>
        <translation>移动</translation>
    </message>
    <message>
        <source>mount</source>
        <translation>安装</translation>
    </message>
    <message>
        <source>mount {0}</source>
        <translation>安装{0}</translation>
    </message>
    <message>
        <source>moving</source>
        <translation>正在移动</translation>
    </message>
    <message>
        <source>muted</source>
        <translation>muted</translation>
    </message>
    <message>
        <source>net</source>
        <translation>net</translation>
    </message>
    <message>
        <source>next touch</source>
        <translation>下一次触测</translation>
    </message>
    <message>
        <source>next: {0}</source>
        <translation>下一个：{0}</translation>
    </message>
    <message>
        <source>no arc would do with this noise</source>
        <translation>在此噪声下任何弧段都不够</translation>
    </message>
    <message>
        <source>no complete scan arrived within {0} s. Try again.</source>
        <translation>{0} s 内没有收到完整的扫描。请重试。</translation>
    </message>
    <message>
        <source>no element</source>
        <translation>没有 element</translation>
    </message>
    <message>
        <source>no grinder {0}; there are {1}</source>
        <translation>没有{0}砂带磨床；现有{1}</translation>
    </message>
    <message>
        <source>no points of its own; it shares its surface with another face</source>
        <translation>没有自己的点；它与另一个面共用表面</translation>
    </message>
    <message>
        <source>no reading of the head at its stop. Check the sensor&apos;s link.</source>
        <translation>没有浮动头在挡块处的读数。请检查传感器的连接。</translation>
    </message>
    <message>
        <source>no sample came within {0} s. Ask again.</source>
        <translation>{0} s 内没有收到样本。请重新请求。</translation>
    </message>
    <message>
        <source>no such table: {0}</source>
        <translation>没有表{0}</translation>
    </message>
    <message>
        <source>nobody confirmed within {0} s: {1}</source>
        <translation>{0} s 内无人确认：{1}</translation>
    </message>
    <message>
        <source>noise of a sample (k = 2)</source>
        <translation>单个样本的噪声（k = 2）</translation>
    </message>
    <message>
        <source>nominal path</source>
        <translation>名义路径</translation>
    </message>
    <message>
        <source>none</source>
        <translation>无</translation>
    </message>
    <message>
        <source>none has a name</source>
        <translation>都没有名称</translation>
    </message>
    <message>
        <source>normal error</source>
        <translation>法向误差</translation>
    </message>
    <message>
        <source>normal error between the samples</source>
        <translation>样本之间的法向误差</translation>
    </message>
    <message>
        <source>normal error, µm</source>
        <translation>法向误差，µm</translation>
    </message>
    <message>
        <source>normal, sample {0}: ({1}, {2}, {3}) is almost at right angles to the head&apos;s motion (y of the tool frame), so the head cannot feel an error there. Check that the normals are given in the tool frame.</source>
        <translation>法线，样本{0}：({1}, {2}, {3}) 与浮动头的运动方向（工具坐标系的 y）几乎垂直，浮动头感觉不到那里的误差。请检查法线是否在工具坐标系中给出。</translation>
    </message>
    <message>
        <source>normal, sample {0}: length {1}, expected a unit vector.</source>
        <translation>法线，样本{0}：长度为{1}，应为单位向量。</translation>
    </message>
    <message>
        <source>normals: expected {0} rows of nx, ny, nz, found shape {1}.</source>
        <translation>法线：应为{0}行 nx、ny、nz，现形状为{1}。</translation>
    </message>
    <message>
        <source>not accepted</source>
        <translation>未接受</translation>
    </message>
    <message>
        <source>not accepted yet</source>
        <translation>尚未接受</translation>
    </message>
    <message>
        <source>not at its target within {0} s, stopped.</source>
        <translation>{0} s 内没有到达目标，已停止。</translation>
    </message>
    <message>
        <source>not done yet</source>
        <translation>尚未完成</translation>
    </message>
    <message>
        <source>not held: shift</source>
        <translation>未约束：移动</translation>
    </message>
    <message>
        <source>not held: turn</source>
        <translation>未约束：转动</translation>
    </message>
    <message>
        <source>nothing</source>
        <translation>nothing</translation>
    </message>
    <message>
        <source>observation {0}</source>
        <translation>观测{0}</translation>
    </message>
    <message>
        <source>observation {0} (counted from 0)</source>
        <translation>观测{0}（从 0 计）</translation>
    </message>
    <message>
        <source>observations[{0}].ball_in_measure_mm: NaN or infinite number. Scan the ball again in that pose.</source>
        <translation>observations[{0}].ball_in_measure_mm：含有 NaN 或无穷大。请在该位姿重新扫描标准球。</translation>
    </message>
    <message>
        <source>observations[{0}].base_from_flange</source>
        <translation>observations[{0}].base_from_flange</translation>
    </message>
    <message>
        <source>of at least {0}</source>
        <translation>，至少{0}</translation>
    </message>
    <message>
        <source>of {0} points in its box only {1} lie on it; the others are clutter or ghosts</source>
        <translation>其框内{0}个点中只有{1}个落在面上；其余为杂物或虚点</translation>
    </message>
    <message>
        <source>off the surface</source>
        <translation>偏离表面</translation>
    </message>
    <message>
        <source>on the CAD model</source>
        <translation>在 CAD 模型上</translation>
    </message>
    <message>
        <source>on the scan</source>
        <translation>在扫描上</translation>
    </message>
    <message>
        <source>only {0} points in its box, {1} are needed</source>
        <translation>其框内只有{0}个点，需要{1}个</translation>
    </message>
    <message>
        <source>open</source>
        <translation>打开</translation>
    </message>
    <message>
        <source>operator</source>
        <translation>操作员</translation>
    </message>
    <message>
        <source>or fix the certified diameter</source>
        <translation>或固定证书直径</translation>
    </message>
    <message>
        <source>other points of the scan</source>
        <translation>扫描的其他点</translation>
    </message>
    <message>
        <source>outlier</source>
        <translation>离群</translation>
    </message>
    <message>
        <source>outside the measured patch</source>
        <translation>测量区域之外</translation>
    </message>
    <message>
        <source>pair</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>pair {0}</source>
        <translation>点对{0}</translation>
    </message>
    <message>
        <source>pairs</source>
        <translation>点对</translation>
    </message>
    <message>
        <source>pass {0} over the points of the faces</source>
        <translation>对各面的点进行第{0}轮</translation>
    </message>
    <message>
        <source>path</source>
        <translation>路径</translation>
    </message>
    <message>
        <source>pattern</source>
        <translation>pattern</translation>
    </message>
    <message>
        <source>pattern: expected &apos;transverse&apos; or &apos;longitudinal&apos;, found &apos;{0}&apos;.</source>
        <translation>pattern：应为“transverse”或“longitudinal”，现为“{0}”。</translation>
    </message>
    <message>
        <source>pcd</source>
        <translation>pcd</translation>
    </message>
    <message>
        <source>pivot {0} in base</source>
        <translation>基座中的枢轴点{0}</translation>
    </message>
    <message>
        <source>place on the blade</source>
        <translation>叶片上的位置</translation>
    </message>
    <message>
        <source>plane</source>
        <translation>平面</translation>
    </message>
    <message>
        <source>planned pose of the flange</source>
        <translation>计划的法兰位姿</translation>
    </message>
    <message>
        <source>planned scan</source>
        <translation>计划的扫描</translation>
    </message>
    <message>
        <source>planned touch</source>
        <translation>计划的触测</translation>
    </message>
    <message>
        <source>planning a path</source>
        <translation>正在规划路径</translation>
    </message>
    <message>
        <source>ply</source>
        <translation>ply</translation>
    </message>
    <message>
        <source>point_in_base_mm: no touch is farther than {0} from the robot base. That looks like metres; points must be in mm.</source>
        <translation>point_in_base_mm：没有触测点距机器人基座超过{0}。看起来单位是米；点必须用 mm。</translation>
    </message>
    <message>
        <source>points</source>
        <translation>点</translation>
    </message>
    <message>
        <source>points come near the model, but not onto the chosen faces</source>
        <translation>点接近模型，但没有落在所选面上</translation>
    </message>
    <message>
        <source>points of the CAD model</source>
        <translation>CAD 模型的点</translation>
    </message>
    <message>
        <source>points of the faces</source>
        <translation>各面的点</translation>
    </message>
    <message>
        <source>points off the chosen faces</source>
        <translation>所选面之外的点</translation>
    </message>
    <message>
        <source>points on the ball</source>
        <translation>标准球上的点</translation>
    </message>
    <message>
        <source>pose kept out of the fit</source>
        <translation>留在拟合之外的位姿</translation>
    </message>
    <message>
        <source>pose left out</source>
        <translation>已排除的位姿</translation>
    </message>
    <message>
        <source>pose that would add most</source>
        <translation>收益最大的位姿</translation>
    </message>
    <message>
        <source>pose {0}</source>
        <translation>位姿{0}</translation>
    </message>
    <message>
        <source>pose {0} is compared with the scan</source>
        <translation>正在将位姿{0}与扫描比较</translation>
    </message>
    <message>
        <source>pose {0} of {1} is aligned</source>
        <translation>正在对齐位姿{0}/{1}</translation>
    </message>
    <message>
        <source>positions</source>
        <translation>positions</translation>
    </message>
    <message>
        <source>positions: expected at least one parameter.</source>
        <translation>positions：应至少有一个参数。</translation>
    </message>
    <message>
        <source>positions: {0} to {1} do not lie within {2} to {3}.</source>
        <translation>positions：{0}到{1}不在{2}到{3}范围内。</translation>
    </message>
    <message>
        <source>predicted normal error, µm</source>
        <translation>预测法向误差，µm</translation>
    </message>
    <message>
        <source>probed</source>
        <translation>已探测</translation>
    </message>
    <message>
        <source>probing</source>
        <translation>探测</translation>
    </message>
    <message>
        <source>probing line {0} of {1}</source>
        <translation>正在探测线{0}/{1}</translation>
    </message>
    <message>
        <source>process {0} on {1}</source>
        <translation>{1}上的进程{0}</translation>
    </message>
    <message>
        <source>program</source>
        <translation>程序</translation>
    </message>
    <message>
        <source>programs</source>
        <translation>programs</translation>
    </message>
    <message>
        <source>progress</source>
        <translation>progress</translation>
    </message>
    <message>
        <source>rad</source>
        <translation>rad</translation>
    </message>
    <message>
        <source>radius</source>
        <translation>半径</translation>
    </message>
    <message>
        <source>radius_mm: expected the head&apos;s radius in mm (5 to 5000), found {0}.</source>
        <translation>radius_mm：应为以 mm 计的浮动头半径（5 到 5000），现为{0}。</translation>
    </message>
    <message>
        <source>read</source>
        <translation>read</translation>
    </message>
    <message>
        <source>reading</source>
        <translation>读数</translation>
    </message>
    <message>
        <source>reading the CAD model</source>
        <translation>正在读取 CAD 模型</translation>
    </message>
    <message>
        <source>reading the head</source>
        <translation>正在读取浮动头</translation>
    </message>
    <message>
        <source>reading the pose</source>
        <translation>正在读取位姿</translation>
    </message>
    <message>
        <source>reading the scales</source>
        <translation>正在读取光栅尺</translation>
    </message>
    <message>
        <source>reading the scans</source>
        <translation>正在读取扫描</translation>
    </message>
    <message>
        <source>reading the session</source>
        <translation>正在读取会话</translation>
    </message>
    <message>
        <source>ready to accept</source>
        <translation>可以接受</translation>
    </message>
    <message>
        <source>record</source>
        <translation>record</translation>
    </message>
    <message>
        <source>redo</source>
        <translation>重做</translation>
    </message>
    <message>
        <source>refused</source>
        <translation>已拒收</translation>
    </message>
    <message>
        <source>registered</source>
        <translation>registered</translation>
    </message>
    <message>
        <source>registering the blade after probing</source>
        <translation>正在对探测后的叶片进行配准</translation>
    </message>
    <message>
        <source>registering the blade before it is presented to the wheel</source>
        <translation>正在对送往接触轮之前的叶片进行配准</translation>
    </message>
    <message>
        <source>registering the clamped blade</source>
        <translation>正在对已装夹的叶片进行配准</translation>
    </message>
    <message>
        <source>registration</source>
        <translation>registration</translation>
    </message>
    <message>
        <source>rejected</source>
        <translation>已剔除</translation>
    </message>
    <message>
        <source>rejected, see the reasons there</source>
        <translation>被拒绝，原因见该步骤</translation>
    </message>
    <message>
        <source>residuals drawn {0} times as long</source>
        <translation>残差放大{0}倍显示</translation>
    </message>
    <message>
        <source>resources</source>
        <translation>resources</translation>
    </message>
    <message>
        <source>robot</source>
        <translation>机器人</translation>
    </message>
    <message>
        <source>robot_sigma_mm is 0 and no ball covariance is given: one of them must be above zero.</source>
        <translation>robot_sigma_mm 为 0 且没有给出球心协方差：其中之一必须大于零。</translation>
    </message>
    <message>
        <source>robot_sigma_mm: expected a number of mm, zero or more, found {0}.</source>
        <translation>robot_sigma_mm：应为零或更大的 mm 数，现为{0}。</translation>
    </message>
    <message>
        <source>rotary</source>
        <translation>旋转</translation>
    </message>
    <message>
        <source>rotary axis</source>
        <translation>旋转轴</translation>
    </message>
    <message>
        <source>rotary shift 1</source>
        <translation>旋转轴偏移 1</translation>
    </message>
    <message>
        <source>rotary shift 2</source>
        <translation>旋转轴偏移 2</translation>
    </message>
    <message>
        <source>rotary tilt 1</source>
        <translation>旋转轴倾斜 1</translation>
    </message>
    <message>
        <source>rotary tilt 2</source>
        <translation>旋转轴倾斜 2</translation>
    </message>
    <message>
        <source>rotation about</source>
        <translation>绕</translation>
    </message>
    <message>
        <source>rotation about tool {0}</source>
        <translation>绕工具{0}的旋转</translation>
    </message>
    <message>
        <source>rotation about {0}</source>
        <translation>绕{0}的旋转</translation>
    </message>
    <message>
        <source>rotation x</source>
        <translation>绕 x 的旋转</translation>
    </message>
    <message>
        <source>rotation y</source>
        <translation>绕 y 的旋转</translation>
    </message>
    <message>
        <source>rotation z</source>
        <translation>绕 z 的旋转</translation>
    </message>
    <message>
        <source>rotation {0} of {1}</source>
        <translation>旋转{0}/{1}</translation>
    </message>
    <message>
        <source>rough</source>
        <translation>粗磨</translation>
    </message>
    <message>
        <source>rwc</source>
        <translation>rwc</translation>
    </message>
    <message>
        <source>sample {0} deleted</source>
        <translation>样本{0}已删除</translation>
    </message>
    <message>
        <source>sample {0} left out</source>
        <translation>样本{0}已排除</translation>
    </message>
    <message>
        <source>sample {0} used again</source>
        <translation>样本{0}重新使用</translation>
    </message>
    <message>
        <source>samples</source>
        <translation>样本</translation>
    </message>
    <message>
        <source>scan</source>
        <translation>扫描</translation>
    </message>
    <message>
        <source>scan left out</source>
        <translation>已排除的扫描</translation>
    </message>
    <message>
        <source>scan {0} of {1}: the first place again</source>
        <translation>扫描{0}/{1}：再次在首个位置</translation>
    </message>
    <message>
        <source>scan {0} of {1}: {2}</source>
        <translation>扫描{0}/{1}：{2}</translation>
    </message>
    <message>
        <source>scan {0}: contains NaN or infinite coordinates; drop these points first.</source>
        <translation>扫描{0}：含有 NaN 或无穷大坐标；请先去掉这些点。</translation>
    </message>
    <message>
        <source>scan {0}: expected points as (N, 3) in mm, found shape {1}.</source>
        <translation>扫描{0}：点应为 (N, 3)（mm），现形状为{1}。</translation>
    </message>
    <message>
        <source>scanner</source>
        <translation>扫描仪</translation>
    </message>
    <message>
        <source>scans</source>
        <translation>次扫描</translation>
    </message>
    <message>
        <source>series</source>
        <translation>series</translation>
    </message>
    <message>
        <source>serpentine</source>
        <translation>serpentine</translation>
    </message>
    <message>
        <source>setting &apos;{0}&apos; changed</source>
        <translation>设置“{0}”已更改</translation>
    </message>
    <message>
        <source>settings</source>
        <translation>settings</translation>
    </message>
    <message>
        <source>shaft</source>
        <translation>轮轴</translation>
    </message>
    <message>
        <source>shaft {0} {1}</source>
        <translation>{0}轮轴{1}</translation>
    </message>
    <message>
        <source>shaft_offset_mm: expected a number of mm, found {0}.</source>
        <translation>shaft_offset_mm：应为 mm 数，现为{0}。</translation>
    </message>
    <message>
        <source>share</source>
        <translation>share</translation>
    </message>
    <message>
        <source>shift along</source>
        <translation>移动方向</translation>
    </message>
    <message>
        <source>shown</source>
        <translation>shown</translation>
    </message>
    <message>
        <source>shroud</source>
        <translation>叶冠</translation>
    </message>
    <message>
        <source>sigma_mm must be above 0 mm, found {0}.</source>
        <translation>sigma_mm 必须大于 0 mm，现为{0}。</translation>
    </message>
    <message>
        <source>sigma_mm: expected a number of mm above zero, found {0}.</source>
        <translation>sigma_mm：应为大于零的 mm 数，现为{0}。</translation>
    </message>
    <message>
        <source>sigma_mm: expected a positive noise in mm, found {0}.</source>
        <translation>sigma_mm：应为正的噪声（mm），现为{0}。</translation>
    </message>
    <message>
        <source>sigma_mm: expected a positive number, found {0}.</source>
        <translation>sigma_mm：应为正数，现为{0}。</translation>
    </message>
    <message>
        <source>signed distance</source>
        <translation>带符号距离</translation>
    </message>
    <message>
        <source>signed distance from the face, µm</source>
        <translation>到面的带符号距离，µm</translation>
    </message>
    <message>
        <source>simulated</source>
        <translation>模拟</translation>
    </message>
    <message>
        <source>since {0}: {1}</source>
        <translation>自{0}起：{1}</translation>
    </message>
    <message>
        <source>software</source>
        <translation>software</translation>
    </message>
    <message>
        <source>solve</source>
        <translation>求解</translation>
    </message>
    <message>
        <source>solve again, no new samples needed</source>
        <translation>请重新求解，不需要新样本</translation>
    </message>
    <message>
        <source>solving again</source>
        <translation>正在重新求解</translation>
    </message>
    <message>
        <source>solving stylus and wheels</source>
        <translation>正在求解测针和接触轮</translation>
    </message>
    <message>
        <source>some</source>
        <translation>若干</translation>
    </message>
    <message>
        <source>speed</source>
        <translation>速度</translation>
    </message>
    <message>
        <source>sphere</source>
        <translation>球面</translation>
    </message>
    <message>
        <source>stage</source>
        <translation>位移台</translation>
    </message>
    <message>
        <source>stage positions</source>
        <translation>位移台位置</translation>
    </message>
    <message>
        <source>stage theta</source>
        <translation>位移台 theta</translation>
    </message>
    <message>
        <source>stage x</source>
        <translation>位移台 x</translation>
    </message>
    <message>
        <source>stage y</source>
        <translation>位移台 y</translation>
    </message>
    <message>
        <source>stage z</source>
        <translation>位移台 z</translation>
    </message>
    <message>
        <source>stage {0}</source>
        <translation>位移台{0}</translation>
    </message>
    <message>
        <source>stage {0}{1}</source>
        <translation>位移台{0}{1}</translation>
    </message>
    <message>
        <source>stale</source>
        <translation>已失效</translation>
    </message>
    <message>
        <source>start (measure_from_work)</source>
        <translation>初值（measure_from_work）</translation>
    </message>
    <message>
        <source>start over</source>
        <translation>重新开始</translation>
    </message>
    <message>
        <source>start {0} is aligned</source>
        <translation>正在对齐初值{0}</translation>
    </message>
    <message>
        <source>started over, {0} deleted</source>
        <translation>已重新开始，删除了{0}</translation>
    </message>
    <message>
        <source>step</source>
        <translation>step</translation>
    </message>
    <message>
        <source>stl</source>
        <translation>stl</translation>
    </message>
    <message>
        <source>stop</source>
        <translation>挡块</translation>
    </message>
    <message>
        <source>stop {0}</source>
        <translation>{0}挡块</translation>
    </message>
    <message>
        <source>stopped</source>
        <translation>已停止</translation>
    </message>
    <message>
        <source>stopped by a person. Begin again to go on.</source>
        <translation>已由人员停止。请重新开始以继续。</translation>
    </message>
    <message>
        <source>stopped by a person. Check that the way is free, then begin again.</source>
        <translation>已由人员停止。请检查通路无障碍，然后重新开始。</translation>
    </message>
    <message>
        <source>stopped on the way. Check that the way is free, then move again.</source>
        <translation>在途中停止。请检查通路无障碍，然后再次移动。</translation>
    </message>
    <message>
        <source>strokes</source>
        <translation>走刀数</translation>
    </message>
    <message>
        <source>stylus</source>
        <translation>测针</translation>
    </message>
    <message>
        <source>suggestion</source>
        <translation>suggestion</translation>
    </message>
    <message>
        <source>superseded</source>
        <translation>superseded</translation>
    </message>
    <message>
        <source>take new samples</source>
        <translation>请采集新样本</translation>
    </message>
    <message>
        <source>taking a scan</source>
        <translation>正在采集扫描</translation>
    </message>
    <message>
        <source>tessellation of {0}: deflection ({1} mm) and angle ({2} rad) must be greater than zero.</source>
        <translation>{0}的网格化：弦高误差（{1} mm）和角度（{2} rad）必须大于零。</translation>
    </message>
    <message>
        <source>test</source>
        <translation>test</translation>
    </message>
    <message>
        <source>text</source>
        <translation>文本</translation>
    </message>
    <message>
        <source>the arm cannot be guided there with this orientation. Choose another one.</source>
        <translation>以此姿态无法将机械臂引导到那里。请选择其他姿态。</translation>
    </message>
    <message>
        <source>the arm cannot take this orientation at ({0}) mm. Choose another pose.</source>
        <translation>机械臂在 ({0}) mm 处无法取此姿态。请选择其他位姿。</translation>
    </message>
    <message>
        <source>the axes have no reference yet. Home the stage first.</source>
        <translation>各轴还没有参考点。请先让位移台回参考点。</translation>
    </message>
    <message>
        <source>the blade is to be clamped</source>
        <translation>要装夹叶片</translation>
    </message>
    <message>
        <source>the block expands to {0} bytes</source>
        <translation>数据块展开为{0}字节</translation>
    </message>
    <message>
        <source>the block is longer than announced</source>
        <translation>数据块比声明的长</translation>
    </message>
    <message>
        <source>the bytes {0}</source>
        <translation>字节{0}</translation>
    </message>
    <message>
        <source>the connection is gone. Check its cable and power, then connect it again.</source>
        <translation>连接已断开。请检查其电缆和电源，然后重新连接。</translation>
    </message>
    <message>
        <source>the head of grinder {0} turns from {1} to {2} degrees, {3} degrees was asked for. Choose another angle.</source>
        <translation>{0}砂带磨床的浮动头可从{1}转到{2}度，要求的是{3}度。请选择其他角度。</translation>
    </message>
    <message>
        <source>the header says {0} triangles, that is {1} bytes, the file has {2}. The file is cut short or no STL.</source>
        <translation>文件头声明{0}个三角形，即{1}字节，而文件有{2}字节。文件被截断或不是 STL。</translation>
    </message>
    <message>
        <source>the motion was not wanted. It stands where it was stopped.</source>
        <translation>该移动未获同意。它停在被停止的位置。</translation>
    </message>
    <message>
        <source>the motion was not wanted: {0}. Nothing has moved.</source>
        <translation>该移动未获同意：{0}。没有任何移动。</translation>
    </message>
    <message>
        <source>the nearest point is {0} mm away from the model&apos;s box</source>
        <translation>最近的点距模型包围盒{0} mm</translation>
    </message>
    <message>
        <source>the number of elements {0}</source>
        <translation>元素数量{0}</translation>
    </message>
    <message>
        <source>the pose is out of reach. Choose another one.</source>
        <translation>该位姿无法到达。请选择其他位姿。</translation>
    </message>
    <message>
        <source>the scanned surface goes on beyond its edge: the fixture, or another part</source>
        <translation>扫描到的表面延伸到其边缘之外：夹具，或其他零件</translation>
    </message>
    <message>
        <source>the version that wrote it</source>
        <translation>写出它的版本</translation>
    </message>
    <message>
        <source>the {0}</source>
        <translation>{0}</translation>
    </message>
    <message>
        <source>the {0} is on the flange. Ask for the stylus to be mounted first.</source>
        <translation>法兰上装的是{0}。请先要求安装测针。</translation>
    </message>
    <message>
        <source>there is no grinder {0}; there are {1}.</source>
        <translation>没有{0}砂带磨床；现有{1}。</translation>
    </message>
    <message>
        <source>thinning the scan</source>
        <translation>正在精简扫描</translation>
    </message>
    <message>
        <source>tightening the filter boxes</source>
        <translation>正在收紧过滤框</translation>
    </message>
    <message>
        <source>tilt of the flange towards x of {B}, deg</source>
        <translation>法兰朝 {B} 的 x 的倾角，deg</translation>
    </message>
    <message>
        <source>tilt of the flange towards y of {B}, deg</source>
        <translation>法兰朝 {B} 的 y 的倾角，deg</translation>
    </message>
    <message>
        <source>tilt {0} deg</source>
        <translation>倾角{0} deg</translation>
    </message>
    <message>
        <source>time</source>
        <translation>时间</translation>
    </message>
    <message>
        <source>tip off the cone&apos;s point, mm</source>
        <translation>针尖偏离锥窝点，mm</translation>
    </message>
    <message>
        <source>tip {0} in flange</source>
        <translation>法兰中的针尖{0}</translation>
    </message>
    <message>
        <source>to go on {0}</source>
        <translation>继续{0}</translation>
    </message>
    <message>
        <source>to probe {0} points of the airfoil on grinder {1} (outline shown)</source>
        <translation>在{1}砂带磨床上探测叶身的{0}个点（显示轮廓）</translation>
    </message>
    <message>
        <source>to the scanning pose &apos;{0}&apos;</source>
        <translation>到扫描位姿“{0}”</translation>
    </message>
    <message>
        <source>tool</source>
        <translation>工具</translation>
    </message>
    <message>
        <source>tool step</source>
        <translation>工具步骤</translation>
    </message>
    <message>
        <source>torus</source>
        <translation>环面</translation>
    </message>
    <message>
        <source>touch</source>
        <translation>触测</translation>
    </message>
    <message>
        <source>touch cone</source>
        <translation>触测锥窝</translation>
    </message>
    <message>
        <source>touch in the fit</source>
        <translation>拟合中的触测</translation>
    </message>
    <message>
        <source>touch left out</source>
        <translation>已排除的触测</translation>
    </message>
    <message>
        <source>touch off the mark&apos;s circle, mm</source>
        <translation>触测偏离标记圆，mm</translation>
    </message>
    <message>
        <source>touch shaft</source>
        <translation>触测轮轴</translation>
    </message>
    <message>
        <source>touch that would add most</source>
        <translation>收益最大的触测</translation>
    </message>
    <message>
        <source>touch {0} (counted from 0)</source>
        <translation>触测{0}（从 0 计）</translation>
    </message>
    <message>
        <source>touches and readings</source>
        <translation>次触测和读数</translation>
    </message>
    <message>
        <source>touches: expected N angles and N points of three numbers, found shapes {0} and {1}.</source>
        <translation>触测：应为 N 个角度和 N 个三个数的点，现形状为{0}和{1}。</translation>
    </message>
    <message>
        <source>touches: expected one angle and three coordinates per touch, all numbers.</source>
        <translation>触测：每次触测应有一个角度和三个坐标，均为数字。</translation>
    </message>
    <message>
        <source>touches[{0}]: NaN or infinite number. Touch the shaft again at that head angle.</source>
        <translation>touches[{0}]：含有 NaN 或无穷大。请在该浮动头角度下重新触测轮轴。</translation>
    </message>
    <message>
        <source>translation along {0}</source>
        <translation>沿{0}的平移</translation>
    </message>
    <message>
        <source>translation of the measuring frame along base</source>
        <translation>测量坐标系的平移沿基座</translation>
    </message>
    <message>
        <source>translation x</source>
        <translation>沿 x 的平移</translation>
    </message>
    <message>
        <source>translation y</source>
        <translation>沿 y 的平移</translation>
    </message>
    <message>
        <source>translation z</source>
        <translation>沿 z 的平移</translation>
    </message>
    <message>
        <source>transverse</source>
        <translation>横向</translation>
    </message>
    <message>
        <source>triangles of the CAD model</source>
        <translation>CAD 模型的三角形</translation>
    </message>
    <message>
        <source>turn about</source>
        <translation>转动轴</translation>
    </message>
    <message>
        <source>two halves apart</source>
        <translation>两半之差</translation>
    </message>
    <message>
        <source>type</source>
        <translation>type</translation>
    </message>
    <message>
        <source>u, around the profile</source>
        <translation>u，沿叶型周向</translation>
    </message>
    <message>
        <source>u, v, error_mm: expected three columns of equal length, found {0}.</source>
        <translation>u、v、error_mm：应为三个等长的列，现为{0}。</translation>
    </message>
    <message>
        <source>unable to open database file</source>
        <translation>数据库文件无法打开</translation>
    </message>
    <message>
        <source>uncertainty, k = 2</source>
        <translation>不确定度，k = 2</translation>
    </message>
    <message>
        <source>undo</source>
        <translation>撤销</translation>
    </message>
    <message>
        <source>undone</source>
        <translation>undone</translation>
    </message>
    <message>
        <source>undone: {0}</source>
        <translation>已撤销：{0}</translation>
    </message>
    <message>
        <source>upper end</source>
        <translation>上端</translation>
    </message>
    <message>
        <source>used</source>
        <translation>已使用</translation>
    </message>
    <message>
        <source>v, along the span</source>
        <translation>v，沿叶高方向</translation>
    </message>
    <message>
        <source>waiting</source>
        <translation>waiting</translation>
    </message>
    <message>
        <source>way</source>
        <translation>行程</translation>
    </message>
    <message>
        <source>way of the contact over all strokes, mm</source>
        <translation>所有走刀的接触行程，mm</translation>
    </message>
    <message>
        <source>way of the wheel, µm</source>
        <translation>接触轮的行程，µm</translation>
    </message>
    <message>
        <source>what the scanner sees</source>
        <translation>扫描仪看到的</translation>
    </message>
    <message>
        <source>wheel</source>
        <translation>接触轮</translation>
    </message>
    <message>
        <source>wheel_radius_mm: expected the wheel&apos;s radius in mm (2 to 1000), found {0}.</source>
        <translation>wheel_radius_mm：应为以 mm 计的接触轮半径（2 到 1000），现为{0}。</translation>
    </message>
    <message>
        <source>where one more scan would add most</source>
        <translation>再扫描一次收益最大处</translation>
    </message>
    <message>
        <source>where the scanner can see</source>
        <translation>扫描仪的可见范围</translation>
    </message>
    <message>
        <source>with</source>
        <translation>同时</translation>
    </message>
    <message>
        <source>worst</source>
        <translation>最差</translation>
    </message>
    <message>
        <source>write</source>
        <translation>write</translation>
    </message>
    <message>
        <source>writing the error surface</source>
        <translation>正在写出误差曲面</translation>
    </message>
    <message>
        <source>writing the program {0}</source>
        <translation>正在写出程序{0}</translation>
    </message>
    <message>
        <source>writing the report</source>
        <translation>正在写出报告</translation>
    </message>
    <message>
        <source>x at {0} mm</source>
        <translation>{0} mm 处的 x</translation>
    </message>
    <message>
        <source>x y z</source>
        <translation>x y z</translation>
    </message>
    <message>
        <source>xyz</source>
        <translation>xyz</translation>
    </message>
    <message>
        <source>y at {0} mm</source>
        <translation>{0} mm 处的 y</translation>
    </message>
    <message>
        <source>{0} As given, the best fit leaves {1} mm RMS.</source>
        <translation>{0}按所给数据，最佳拟合留有{1} mm RMS。</translation>
    </message>
    <message>
        <source>{0} Choose planes and cylinders.</source>
        <translation>{0}请选择平面和圆柱面。</translation>
    </message>
    <message>
        <source>{0} Leave it out, or delete it and scan again.</source>
        <translation>{0}请将其排除，或删除后重新扫描。</translation>
    </message>
    <message>
        <source>{0} The motion was stopped.</source>
        <translation>{0}移动已停止。</translation>
    </message>
    <message>
        <source>{0} again</source>
        <translation>{0}（再次）</translation>
    </message>
    <message>
        <source>{0} and others</source>
        <translation>{0}等</translation>
    </message>
    <message>
        <source>{0} and {1} of it on the model</source>
        <translation>{0}，其中{1}在模型上</translation>
    </message>
    <message>
        <source>{0} angle</source>
        <translation>{0}角度</translation>
    </message>
    <message>
        <source>{0} can&apos;t be used for registration. {1}</source>
        <translation>{0}不能用于配准。{1}</translation>
    </message>
    <message>
        <source>{0} cannot be chosen. {1}</source>
        <translation>{0}不能选择。{1}</translation>
    </message>
    <message>
        <source>{0} cannot go from {1} to {2} {3}: the limits are {4} to {5} {6}. Choose a target inside them.</source>
        <translation>{0}不能从{1}到{2} {3}：限值为{4}到{5} {6}。请选择限值以内的目标。</translation>
    </message>
    <message>
        <source>{0} faces are chosen, at least {1} are needed. Choose more.</source>
        <translation>选择了{0}个面，至少需要{1}个。请选择更多。</translation>
    </message>
    <message>
        <source>{0} failed. {1}</source>
        <translation>{0}失败。{1}</translation>
    </message>
    <message>
        <source>{0} flange poses but {1} ball centres: each observation needs one of each.</source>
        <translation>有{0}个法兰位姿但有{1}个球心：每个观测两者各需一个。</translation>
    </message>
    <message>
        <source>{0} force</source>
        <translation>{0}力</translation>
    </message>
    <message>
        <source>{0} has no filter box. {1}</source>
        <translation>{0}没有过滤框。{1}</translation>
    </message>
    <message>
        <source>{0} has no result to accept. Solve it first.</source>
        <translation>{0}没有可接受的结果。请先求解。</translation>
    </message>
    <message>
        <source>{0} has no result yet.</source>
        <translation>{0}还没有结果。</translation>
    </message>
    <message>
        <source>{0} has no samples yet. Take them first.</source>
        <translation>{0}还没有样本。请先采集。</translation>
    </message>
    <message>
        <source>{0} is accepted already.</source>
        <translation>{0}已经接受。</translation>
    </message>
    <message>
        <source>{0} is given twice.</source>
        <translation>{0}给出了两次。</translation>
    </message>
    <message>
        <source>{0} is missing; expected a table of that name.</source>
        <translation>缺少{0}；应有该名称的表。</translation>
    </message>
    <message>
        <source>{0} is no command</source>
        <translation>{0}不是命令</translation>
    </message>
    <message>
        <source>{0} is not accepted yet.</source>
        <translation>{0}尚未接受。</translation>
    </message>
    <message>
        <source>{0} is not started.</source>
        <translation>{0}未开始。</translation>
    </message>
    <message>
        <source>{0} is rejected.</source>
        <translation>{0}被拒绝。</translation>
    </message>
    <message>
        <source>{0} is stale.</source>
        <translation>{0}已失效。</translation>
    </message>
    <message>
        <source>{0} is stale. {1}</source>
        <translation>{0}已失效。{1}</translation>
    </message>
    <message>
        <source>{0} is {1} {2}, the limit is {3} {4}. {5}</source>
        <translation>{0}为{1} {2}，限值为{3} {4}。{5}</translation>
    </message>
    <message>
        <source>{0} is {1}, expected &quot;property TYPE NAME&quot; with TYPE such as float or double.</source>
        <translation>{0}为{1}，应为“property TYPE NAME”，其中 TYPE 例如 float 或 double。</translation>
    </message>
    <message>
        <source>{0} is {1}, expected format, element, property or comment.</source>
        <translation>{0}为{1}，应为 format、element、property 或 comment。</translation>
    </message>
    <message>
        <source>{0} lines of an earlier clamping or of other frames do not count any more.</source>
        <translation>有{0}条线属于先前的装夹或其他坐标系，不再有效。</translation>
    </message>
    <message>
        <source>{0} moved by {1} mm{2}</source>
        <translation>{0}移动了{1} mm{2}</translation>
    </message>
    <message>
        <source>{0} must be above 0 mm, found {1}.</source>
        <translation>{0}必须大于 0 mm，现为{1}。</translation>
    </message>
    <message>
        <source>{0} must lie in {1} .. {2} of the surface, found {3} .. {4}.</source>
        <translation>{0}必须在曲面的{1} .. {2}范围内，现为{3} .. {4}。</translation>
    </message>
    <message>
        <source>{0} names the format {1}, expected one of {2}.</source>
        <translation>{0}的格式为{1}，应为{2}之一。</translation>
    </message>
    <message>
        <source>{0} names the property {1} a second time.</source>
        <translation>{0}再次给出了属性{1}。</translation>
    </message>
    <message>
        <source>{0} needs {1}, which has no result yet.</source>
        <translation>{0}需要{1}，而后者还没有结果。</translation>
    </message>
    <message>
        <source>{0} needs {1}, which is {2}.</source>
        <translation>{0}需要{1}，而后者{2}。</translation>
    </message>
    <message>
        <source>{0} observations (the first is {1}) are the only witnesses of something; at most {2} may be. Add poses like them.</source>
        <translation>有{0}个观测（第一个为{1}）是某个量的唯一见证；最多可有{2}个。请增加与它们相似的位姿。</translation>
    </message>
    <message>
        <source>{0} of at least {1} pairs are picked: pick {2} more, each on the scan and on the CAD model, spread over the whole blade.</source>
        <translation>已选取{0}个点对，至少需要{1}个：请再选取{2}个，每个都在扫描和 CAD 模型上选取，分布在整个叶片上。</translation>
    </message>
    <message>
        <source>{B} {0} mm</source>
        <translation>{B} {0} mm</translation>
    </message>
    <message>
        <source>{H {0}, by the drawing}</source>
        <translation>{H {0}，按图纸}</translation>
    </message>
    <message>
        <source>{H {0}}</source>
        <translation>{H {0}}</translation>
    </message>
    <message>
        <source>{M} in {B}, turn</source>
        <translation>{M} 在 {B} 中的转角</translation>
    </message>
    <message>
        <source>± of the surface (k = 2)</source>
        <translation>曲面的 ±（k = 2）</translation>
    </message>
    <message>
        <source>± of the surface at the contact, largest (k = 2)</source>
        <translation>接触点处曲面的 ±，最大（k = 2）</translation>
    </message>
    <message>
        <source>± of the surface at the contact, typical (k = 2)</source>
        <translation>接触点处曲面的 ±，典型（k = 2）</translation>
    </message>
    <message>
        <source>± there (k = 2) from {0} to {1} µm</source>
        <translation>该处的 ±（k = 2）从{0}变为{1} µm</translation>
    </message>
    <message>
        <source>{0} of {1} check lines are left out. A check that fails may not be left out: delete it and probe it again.</source>
        <translation>{1}条检验线中有{0}条被排除。不合格的检验不得排除：请删除后重新探测。</translation>
    </message>
    <message>
        <source>(u {0}, v {1})</source>
        <translation>(u {0}, v {1})</translation>
    </message>
    <message>
        <source>Ball</source>
        <translation>标准球</translation>
    </message>
    <message>
        <source>Ball in the newest scan</source>
        <translation>最新扫描中的标准球</translation>
    </message>
    <message>
        <source>Base</source>
        <translation>基坐标系</translation>
    </message>
    <message>
        <source>CAD model found in the scan</source>
        <translation>在扫描中找到的 CAD 模型</translation>
    </message>
    <message>
        <source>Directory not empty</source>
        <translation>文件夹不为空</translation>
    </message>
    <message>
        <source>Error surface</source>
        <translation>误差曲面</translation>
    </message>
    <message>
        <source>File exists</source>
        <translation>文件已存在</translation>
    </message>
    <message>
        <source>File name too long</source>
        <translation>文件名过长</translation>
    </message>
    <message>
        <source>Fine workpiece</source>
        <translation>工件精定位</translation>
    </message>
    <message>
        <source>Input/output error</source>
        <translation>输入/输出错误</translation>
    </message>
    <message>
        <source>Is a directory</source>
        <translation>这是一个文件夹</translation>
    </message>
    <message>
        <source>It has slipped in its clamp: fasten the clamp and acquire again.</source>
        <translation>它在夹具中滑动了：请紧固夹具并重新采集。</translation>
    </message>
    <message>
        <source>No space left on device</source>
        <translation>磁盘空间不足</translation>
    </message>
    <message>
        <source>No such file or directory</source>
        <translation>没有该文件或文件夹</translation>
    </message>
    <message>
        <source>Not a directory</source>
        <translation>不是文件夹</translation>
    </message>
    <message>
        <source>Operation not permitted</source>
        <translation>不允许该操作</translation>
    </message>
    <message>
        <source>Permission denied</source>
        <translation>没有权限</translation>
    </message>
    <message>
        <source>Read-only file system</source>
        <translation>文件系统为只读</translation>
    </message>
    <message>
        <source>Rough workpiece</source>
        <translation>工件粗定位</translation>
    </message>
    <message>
        <source>Shrouded turbine blade, fir-tree root, airfoil span 200 mm, twist 25 degrees</source>
        <translation>带冠涡轮叶片，枞树形榫头，叶身高 200 mm，扭转 25 度</translation>
    </message>
    <message>
        <source>Shrouded turbine blade, fir-tree root, airfoil span 216 mm, twist 30 degrees</source>
        <translation>带冠涡轮叶片，枞树形榫头，叶身高 216 mm，扭转 30 度</translation>
    </message>
    <message>
        <source>Stylus and tool</source>
        <translation>测针与工具</translation>
    </message>
    <message>
        <source>The distance of the blade from where the scans before found it</source>
        <translation>叶片与先前扫描所测位置的距离</translation>
    </message>
    <message>
        <source>Too many open files</source>
        <translation>打开的文件过多</translation>
    </message>
    <message>
        <source>failed</source>
        <translation>失败</translation>
    </message>
    <message>
        <source>in {0} .. {1}</source>
        <translation>（{0} .. {1}）</translation>
    </message>
    <message>
        <source>next scan</source>
        <translation>下一次扫描</translation>
    </message>
    <message>
        <source>not started</source>
        <translation>未开始</translation>
    </message>
    <message>
        <source>running</source>
        <translation>进行中</translation>
    </message>
    <message>
        <source>warm</source>
        <translation>warm</translation>
    </message>
    <message>
        <source>{0} is {1}.</source>
        <translation>{0}{1}。</translation>
    </message>
    <message>
        <source>{0} of {1} grid nodes have no sample: {2}{3}.</source>
        <translation>{1}个网格节点中有{0}个没有样本：{2}{3}。</translation>
    </message>
    <message>
        <source>{0} of {1} lines are left out, at most {2} may be. Delete them and probe them again.</source>
        <translation>{1}条线中有{0}条被排除，最多可有{2}条。请删除后重新探测。</translation>
    </message>
    <message>
        <source>{0} of {1} lines of the airfoil are probed.</source>
        <translation>叶身的{1}条线中已探测{0}条。</translation>
    </message>
    <message>
        <source>{0} of {1} planned scans are missing: {2}. Take the missing scans.</source>
        <translation>{1}次计划扫描中缺少{0}次：{2}。请采集缺少的扫描。</translation>
    </message>
    <message>
        <source>{0} of {1} planned touches and readings are missing. Take the missing ones.</source>
        <translation>{1}次计划的触测和读数中缺少{0}次。请采集缺少的。</translation>
    </message>
    <message>
        <source>{0} of {1} points were found to be wrong.</source>
        <translation>{1}个点中有{0}个被判为错误。</translation>
    </message>
    <message>
        <source>{0} of {1} touches were rejected, at most {2} may be. Check that the tip sits in the cone and repeat.</source>
        <translation>{1}次触测中有{0}次被剔除，最多可有{2}次。请检查针尖是否坐落在锥窝内，然后重做。</translation>
    </message>
    <message>
        <source>{0} of {1} {2}</source>
        <translation>{0}/{1} {2}</translation>
    </message>
    <message>
        <source>{0} or normal, sample {1}: not a number ({2} such samples).</source>
        <translation>{0}或法线，样本{1}：不是数字（这样的样本有{2}个）。</translation>
    </message>
    <message>
        <source>{0} pairs are picked.</source>
        <translation>已选取{0}个点对。</translation>
    </message>
    <message>
        <source>{0} samples</source>
        <translation>{0}个样本</translation>
    </message>
    <message>
        <source>{0} samples are too few for {1} unknowns: nothing is left to estimate the noise from. Use fewer intervals, or state the noise.</source>
        <translation>{0}个样本对{1}个未知数太少：没有剩余数据可用来估计噪声。请减少区间数，或给出噪声。</translation>
    </message>
    <message>
        <source>{0} samples with an error, at least {1} are needed. Measure more points.</source>
        <translation>有误差的样本为{0}个，至少需要{1}个。请测量更多的点。</translation>
    </message>
    <message>
        <source>{0} scans are left out.</source>
        <translation>有{0}次扫描被排除。</translation>
    </message>
    <message>
        <source>{0} serial_pattern: {1} is no regular expression ({2}).</source>
        <translation>{0} serial_pattern：{1}不是正则表达式（{2}）。</translation>
    </message>
    <message>
        <source>{0} stands on steps that are not accepted. Accept them first.</source>
        <translation>{0}所依据的步骤尚未接受。请先接受它们。</translation>
    </message>
    <message>
        <source>{0} touches are left out.</source>
        <translation>有{0}次触测被排除。</translation>
    </message>
    <message>
        <source>{0} waits to be accepted.</source>
        <translation>{0}等待接受。</translation>
    </message>
    <message>
        <source>{0} was accepted after this was solved.</source>
        <translation>此结果求解之后{0}才被接受。</translation>
    </message>
    <message>
        <source>{0} was accepted again</source>
        <translation>{0}已重新接受</translation>
    </message>
    <message>
        <source>{0} was not found in the scan: the best pose puts {1} of it on the model, at least {2} is needed. Check the blade type, and scan edge plate and shroud with less of the fixture.</source>
        <translation>扫描中没有找到{0}：最佳位姿使其{1}落在模型上，至少需要{2}。请检查叶片型号，并扫描缘板和叶冠，减少夹具部分。</translation>
    </message>
    <message>
        <source>{0} was rejected and cannot be accepted. {1}</source>
        <translation>{0}被拒绝，不能接受。{1}</translation>
    </message>
    <message>
        <source>{0} was solved again and waits to be accepted</source>
        <translation>{0}已重新求解，等待接受</translation>
    </message>
    <message>
        <source>{0} was solved again meanwhile. Solve it once more and look at the result.</source>
        <translation>{0}在此期间已重新求解。请再求解一次并查看结果。</translation>
    </message>
    <message>
        <source>{0} went back to its accepted result</source>
        <translation>{0}恢复为其已接受的结果</translation>
    </message>
    <message>
        <source>{0} {1} is missing.</source>
        <translation>缺少{0} {1}。</translation>
    </message>
    <message>
        <source>{0} {1}: expected a face name or id, found {2}.</source>
        <translation>{0} {1}：应为面的名称或编号，现为{2}。</translation>
    </message>
    <message>
        <source>{0} {1}: expected a list of face names or ids, found {2}.</source>
        <translation>{0} {1}：应为面的名称或编号的列表，现为{2}。</translation>
    </message>
    <message>
        <source>{0} {1}: expected a number {2}, found {3}.</source>
        <translation>{0} {1}：应为数字{2}，现为{3}。</translation>
    </message>
    <message>
        <source>{0} {1}: expected a text, found {2}.</source>
        <translation>{0} {1}：应为文本，现为{2}。</translation>
    </message>
    <message>
        <source>{0} {1}: expected a whole number of at least {2}, found {3}.</source>
        <translation>{0} {1}：应为不小于{2}的整数，现为{3}。</translation>
    </message>
    <message>
        <source>{0} {1}: expected three numbers, found {2}.</source>
        <translation>{0} {1}：应为三个数，现为{2}。</translation>
    </message>
    <message>
        <source>{0} {1}: unknown field.</source>
        <translation>{0} {1}：未知字段。</translation>
    </message>
    <message>
        <source>{0} {1}_max: must be greater than {2}_min = {3}, found {4}.</source>
        <translation>{0} {1}_max：必须大于{2}_min = {3}，现为{4}。</translation>
    </message>
    <message>
        <source>{0}, RMS on the faces {1} µm</source>
        <translation>{0}，面上 RMS {1} µm</translation>
    </message>
    <message>
        <source>{0}, but one of about {1} mm is there. Check the diameter.{2}</source>
        <translation>{0}，但有一个约{1} mm 的球。请检查直径。{2}</translation>
    </message>
    <message>
        <source>{0}, contacts</source>
        <translation>{0}，接触点</translation>
    </message>
    <message>
        <source>{0}, contacts left out</source>
        <translation>{0}，去掉的接触点</translation>
    </message>
    <message>
        <source>{0}, largest speed of the flange</source>
        <translation>{0}，法兰的最大速度</translation>
    </message>
    <message>
        <source>{0}, not confirmed, RMS of the pairs {1} mm</source>
        <translation>{0}，未证实，点对 RMS {1} mm</translation>
    </message>
    <message>
        <source>{0}, read back: largest difference of a contact</source>
        <translation>{0}，回读：接触点的最大差别</translation>
    </message>
    <message>
        <source>{0}, read back: largest difference of a pose</source>
        <translation>{0}，回读：位姿的最大差别</translation>
    </message>
    <message>
        <source>{0}, read back: largest turn</source>
        <translation>{0}，回读：最大转角</translation>
    </message>
    <message>
        <source>{0}, so a shift of its zero would not show. {1}</source>
        <translation>{0}，因此其零点的偏移不会显示。{1}</translation>
    </message>
    <message>
        <source>{0}, strokes</source>
        <translation>{0}，走刀数</translation>
    </message>
    <message>
        <source>{0}, time</source>
        <translation>{0}，时间</translation>
    </message>
    <message>
        <source>{0}, turned</source>
        <translation>{0}，已转动</translation>
    </message>
    <message>
        <source>{0}, way of the contact</source>
        <translation>{0}，接触行程</translation>
    </message>
    <message>
        <source>{0}. Aim the scanner at the ball and see that nothing hides it.</source>
        <translation>{0}。请将扫描仪对准标准球，并确认没有遮挡。</translation>
    </message>
    <message>
        <source>{0}: Rg by the touches alone, certified {1} mm</source>
        <translation>{0}：仅由触测得到的 Rg，证书值{1} mm</translation>
    </message>
    <message>
        <source>{0}: [blade] step: there is no file {1} beside the type file.</source>
        <translation>{0}：[blade] step：型号文件旁边没有文件{1}。</translation>
    </message>
    <message>
        <source>{0}: [truth.{1}] lacks or does not know: {2}.</source>
        <translation>{0}：[truth.{1}] 缺少或含有未知项：{2}。</translation>
    </message>
    <message>
        <source>{0}: a PCD file must begin with header lines VERSION and FIELDS, found {1}.</source>
        <translation>{0}：PCD 文件必须以文件头行 VERSION 和 FIELDS 开头，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: a PLY file must begin with a line &quot;ply&quot;, found {1}.</source>
        <translation>{0}：PLY 文件必须以一行“ply”开头，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: after the {1} vertices of the header {2} bytes are left, expected {3}. The header does not describe this file.</source>
        <translation>{0}：文件头的{1}个顶点之后还剩{2}字节，应为{3}。文件头与该文件不符。</translation>
    </message>
    <message>
        <source>{0}: all {1} points are NaN or (0, 0, 0), which means &quot;no measurement&quot;. Scan again with more exposure or a shorter distance.</source>
        <translation>{0}：全部{1}个点为 NaN 或 (0, 0, 0)，即“无测量值”。请加大曝光或缩短距离重新扫描。</translation>
    </message>
    <message>
        <source>{0}: arc between the outermost touches</source>
        <translation>{0}：最外侧触测之间的弧段</translation>
    </message>
    <message>
        <source>{0}: arc that would be needed</source>
        <translation>{0}：所需的弧段</translation>
    </message>
    <message>
        <source>{0}: byte {1} is {2}; the file is binary, expected text with x y z per line.</source>
        <translation>{0}：第{1}字节为{2}；文件是二进制的，应为每行 x y z 的文本。</translation>
    </message>
    <message>
        <source>{0}: cannot be read as a cell file: {1}</source>
        <translation>{0}：不能作为单元文件读取：{1}</translation>
    </message>
    <message>
        <source>{0}: difference to the certified Rg</source>
        <translation>{0}：与证书 Rg 之差</translation>
    </message>
    <message>
        <source>{0}: expected 1 or -1, found {1}.</source>
        <translation>{0}：应为 1 或 -1，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected [first, last] with first below last, found {1}.</source>
        <translation>{0}：应为 [first, last] 且 first 小于 last，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected a 4x4 matrix of numbers, row by row.</source>
        <translation>{0}：应为逐行给出的 4x4 数字矩阵。</translation>
    </message>
    <message>
        <source>{0}: expected a 4x4 matrix, found shape {1}.</source>
        <translation>{0}：应为 4x4 矩阵，现形状为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected a length of at least 0.001 mm, found {1}.</source>
        <translation>{0}：长度应至少为 0.001 mm，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected a list of {1} numbers, found {2}.</source>
        <translation>{0}：应为{1}个数的列表，现为{2}。</translation>
    </message>
    <message>
        <source>{0}: expected a number above zero, found {1}.</source>
        <translation>{0}：应为大于零的数，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected a number, found {1}.</source>
        <translation>{0}：应为数字，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected a whole number, found {1}.</source>
        <translation>{0}：应为整数，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected one element &quot;vertex&quot; in the PLY header, found {1}.</source>
        <translation>{0}：PLY 文件头中应有一个“vertex”元素，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected rows of three numbers in mm (N x 3), found shape {1}.</source>
        <translation>{0}：应为每行三个数（mm，N x 3），现形状为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected rows of three numbers in mm.</source>
        <translation>{0}：应为每行三个数（mm）。</translation>
    </message>
    <message>
        <source>{0}: expected text, found {1}.</source>
        <translation>{0}：应为文本，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected the fields x y z once each, found {1}.</source>
        <translation>{0}：字段 x y z 应各出现一次，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected true or false, found {1}.</source>
        <translation>{0}：应为 true 或 false，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: expected {1} numbers, found {2}.</source>
        <translation>{0}：应为{1}个数，现为{2}。</translation>
    </message>
    <message>
        <source>{0}: format {1}, expected {2}. Use {3} to open it.</source>
        <translation>{0}：格式为{1}，应为{2}。请使用{3}打开。</translation>
    </message>
    <message>
        <source>{0}: head axis in {B}, direction {1}</source>
        <translation>{0}：浮动头轴在 {B} 中，方向{1}</translation>
    </message>
    <message>
        <source>{0}: head axis, uncertainty of its direction (k = 2)</source>
        <translation>{0}：浮动头轴，方向的不确定度（k = 2）</translation>
    </message>
    <message>
        <source>{0}: line {1} has {2} characters, expected x y z.</source>
        <translation>{0}：第{1}行有{2}个字符，应为 x y z。</translation>
    </message>
    <message>
        <source>{0}: line {1} is {2}, expected {3} numbers{4}.</source>
        <translation>{0}：第{1}行为{2}，应为{3}个数{4}。</translation>
    </message>
    <message>
        <source>{0}: line {1} names {2} columns but not x, y and z once each: {3}. Name the three columns x, y, z.</source>
        <translation>{0}：第{1}行命名了{2}列，但 x、y、z 没有各出现一次：{3}。请将三列命名为 x、y、z。</translation>
    </message>
    <message>
        <source>{0}: line {1} of the PCD header begins with {2}, expected one of {3}.</source>
        <translation>{0}：PCD 文件头第{1}行以{2}开头，应为{3}之一。</translation>
    </message>
    <message>
        <source>{0}: line {1} of the PLY header</source>
        <translation>{0}：PLY 文件头第{1}行</translation>
    </message>
    <message>
        <source>{0}: missing from the path job.</source>
        <translation>{0}：路径作业中缺少此项。</translation>
    </message>
    <message>
        <source>{0}: no B-spline face found that could be the airfoil.</source>
        <translation>{0}：没有找到可作为叶身的 B 样条面。</translation>
    </message>
    <message>
        <source>{0}: no face {1}. The model has faces 1 to {2}; names: {3}.</source>
        <translation>{0}：没有面{1}。模型有面 1 到{2}；名称：{3}。</translation>
    </message>
    <message>
        <source>{0}: no session can be begun here ({1}). Check the disk.</source>
        <translation>{0}：不能在此新建会话（{1}）。请检查磁盘。</translation>
    </message>
    <message>
        <source>{0}: no session can be begun here ({1}). Choose another folder.</source>
        <translation>{0}：不能在此新建会话（{1}）。请选择其他文件夹。</translation>
    </message>
    <message>
        <source>{0}: no session here, {1} is missing. Give the folder of a session.</source>
        <translation>{0}：此处没有会话，缺少{1}。请给出会话的文件夹。</translation>
    </message>
    <message>
        <source>{0}: no such truth setting: {1}.</source>
        <translation>{0}：没有这样的真值设置：{1}。</translation>
    </message>
    <message>
        <source>{0}: none of its {1} faces is a plane or a cylinder that registration can use.</source>
        <translation>{0}：其{1}个面中没有配准可用的平面或圆柱面。</translation>
    </message>
    <message>
        <source>{0}: not a STEP file; it begins with {1}, expected {2}.</source>
        <translation>{0}：不是 STEP 文件；它以{1}开头，应为{2}。</translation>
    </message>
    <message>
        <source>{0}: not a readable STEP file.</source>
        <translation>{0}：不是可读的 STEP 文件。</translation>
    </message>
    <message>
        <source>{0}: not a valid TOML file ({1}).</source>
        <translation>{0}：不是有效的 TOML 文件（{1}）。</translation>
    </message>
    <message>
        <source>{0}: nothing was changed, the database cannot be written ({1}). Check the disk.</source>
        <translation>{0}：没有任何更改，数据库无法写入（{1}）。请检查磁盘。</translation>
    </message>
    <message>
        <source>{0}: origin of {H} in {B},</source>
        <translation>{0}：{H} 的原点在 {B} 中的位置</translation>
    </message>
    <message>
        <source>{0}: point {1} has a coordinate of {2} mm, beyond any scanner. The file is damaged, or its header describes other data.</source>
        <translation>{0}：第{1}个点的坐标为{2} mm，超出任何扫描仪的范围。文件已损坏，或其文件头描述的是其他数据。</translation>
    </message>
    <message>
        <source>{0}: residuals of the angle sensor, RMS</source>
        <translation>{0}：角度传感器残差，RMS</translation>
    </message>
    <message>
        <source>{0}: residuals of the fit, RMS</source>
        <translation>{0}：拟合残差，RMS</translation>
    </message>
    <message>
        <source>{0}: scale of the angle sensor by the touches alone</source>
        <translation>{0}：仅由触测得到的角度传感器比例系数</translation>
    </message>
    <message>
        <source>{0}: the PCD field {1} has COUNT {2}, expected 1.</source>
        <translation>{0}：PCD 字段{1}的 COUNT 为{2}，应为 1。</translation>
    </message>
    <message>
        <source>{0}: the PCD field {1} has COUNT {2}, expected at most 65536.</source>
        <translation>{0}：PCD 字段{1}的 COUNT 为{2}，应不超过 65536。</translation>
    </message>
    <message>
        <source>{0}: the PCD field {1} has TYPE {2} and SIZE {3}, expected e.g. F and 4.</source>
        <translation>{0}：PCD 字段{1}的 TYPE 为{2}、SIZE 为{3}，应例如为 F 和 4。</translation>
    </message>
    <message>
        <source>{0}: the PCD header has no DATA line; the file is cut short or damaged.</source>
        <translation>{0}：PCD 文件头没有 DATA 行；文件被截断或损坏。</translation>
    </message>
    <message>
        <source>{0}: the PCD header lacks {1}.</source>
        <translation>{0}：PCD 文件头缺少{1}。</translation>
    </message>
    <message>
        <source>{0}: the PCD header names {1} fields, but {2} SIZE, {3} TYPE and {4} COUNT.</source>
        <translation>{0}：PCD 文件头命名了{1}个字段，但有{2}个 SIZE、{3}个 TYPE 和{4}个 COUNT。</translation>
    </message>
    <message>
        <source>{0}: the PCD header says DATA {1}, expected ascii, binary or binary_compressed.</source>
        <translation>{0}：PCD 文件头声明 DATA {1}，应为 ascii、binary 或 binary_compressed。</translation>
    </message>
    <message>
        <source>{0}: the PCD header says {1} points, but WIDTH {2} times HEIGHT {3} is {4}.</source>
        <translation>{0}：PCD 文件头声明{1}个点，但 WIDTH {2}乘以 HEIGHT {3}为{4}。</translation>
    </message>
    <message>
        <source>{0}: the PLY header has no end_header line; the file is cut short or damaged.</source>
        <translation>{0}：PLY 文件头没有 end_header 行；文件被截断或损坏。</translation>
    </message>
    <message>
        <source>{0}: the PLY header has no format line, expected e.g. &quot;format ascii 1.0&quot;.</source>
        <translation>{0}：PLY 文件头没有 format 行，应例如为“format ascii 1.0”。</translation>
    </message>
    <message>
        <source>{0}: the STEP file can&apos;t be opened ({1}).</source>
        <translation>{0}：STEP 文件无法打开（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the STEP file can&apos;t be opened again ({1}).</source>
        <translation>{0}：STEP 文件无法再次打开（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the STEP file can&apos;t be parsed; its text is damaged. Export it again.</source>
        <translation>{0}：STEP 文件无法解析；其文本已损坏。请重新导出。</translation>
    </message>
    <message>
        <source>{0}: the STEP file can&apos;t be read by the CAD kernel ({1}). Export it again.</source>
        <translation>{0}：CAD 内核无法读取该 STEP 文件（{1}）。请重新导出。</translation>
    </message>
    <message>
        <source>{0}: the STEP file holds no shape that can be read; expected the solid of a blade.</source>
        <translation>{0}：STEP 文件中没有可读取的形状；应为叶片实体。</translation>
    </message>
    <message>
        <source>{0}: the STEP file holds no solid and no face; expected the solid of a blade. Export it as a solid body, not as wireframe or an empty assembly.</source>
        <translation>{0}：STEP 文件中没有实体也没有面；应为叶片实体。请导出为实体，而不是线框或空装配。</translation>
    </message>
    <message>
        <source>{0}: the STEP file is cut off; its end mark {1} is missing after {2} bytes. Copy or export it again.</source>
        <translation>{0}：STEP 文件被截断；{2}字节之后缺少结束标记{1}。请重新复制或导出。</translation>
    </message>
    <message>
        <source>{0}: the STEP file is damaged at {1}; expected `#number = NAME(..)`. Copy or export it again.</source>
        <translation>{0}：STEP 文件在{1}处损坏；应为 `#number = NAME(..)`。请重新复制或导出。</translation>
    </message>
    <message>
        <source>{0}: the STEP file is damaged; a {1} entity has fields of the wrong kind. Copy or export it again.</source>
        <translation>{0}：STEP 文件已损坏；{1}实体的字段类型错误。请重新复制或导出。</translation>
    </message>
    <message>
        <source>{0}: the STEP file is damaged; {1} entities are referred to but missing, the first is #{2}. Copy or export it again.</source>
        <translation>{0}：STEP 文件已损坏；有{1}个被引用的实体缺失，第一个为 #{2}。请重新复制或导出。</translation>
    </message>
    <message>
        <source>{0}: the STEP file was changed after it was read. Read it anew.</source>
        <translation>{0}：STEP 文件在读取后被更改。请重新读取。</translation>
    </message>
    <message>
        <source>{0}: the STL file holds no facets.</source>
        <translation>{0}：STL 文件中没有三角面。</translation>
    </message>
    <message>
        <source>{0}: the axes of the rotation part are not at right angles. Give a pure rotation.</source>
        <translation>{0}：旋转部分的各轴不互相垂直。请给出纯旋转。</translation>
    </message>
    <message>
        <source>{0}: the blade type can&apos;t be opened ({1}).</source>
        <translation>{0}：叶片型号文件无法打开（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the chosen faces cannot be kept ({1}).</source>
        <translation>{0}：所选面无法保存（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the chosen faces cannot be read ({1}). Remove the file to begin anew.</source>
        <translation>{0}：所选面无法读取（{1}）。请删除该文件以重新开始。</translation>
    </message>
    <message>
        <source>{0}: the cloud cannot be written: {1}. The sample was not kept.</source>
        <translation>{0}：点云无法写入：{1}。样本没有保存。</translation>
    </message>
    <message>
        <source>{0}: the cloud of sample {1} cannot be read ({2}).</source>
        <translation>{0}：样本{1}的点云无法读取（{2}）。</translation>
    </message>
    <message>
        <source>{0}: the compressed body announces {1} bytes, the header {2} points of {3} bytes, that is {4}.</source>
        <translation>{0}：压缩数据声明{1}字节，文件头声明{2}个{3}字节的点，即{4}。</translation>
    </message>
    <message>
        <source>{0}: the compressed body is damaged: {1}, expected {2} bytes.</source>
        <translation>{0}：压缩数据已损坏：{1}，应为{2}字节。</translation>
    </message>
    <message>
        <source>{0}: the compressed body is missing; the file is cut short.</source>
        <translation>{0}：缺少压缩数据；文件被截断。</translation>
    </message>
    <message>
        <source>{0}: the compressed body should have {1} bytes and hold {2}, the file has {3}. The file is cut short or damaged.</source>
        <translation>{0}：压缩数据应有{1}字节并包含{2}，文件有{3}。文件被截断或损坏。</translation>
    </message>
    <message>
        <source>{0}: the ending {1} is not a point cloud; supported are {2}.</source>
        <translation>{0}：扩展名{1}不是点云；支持的有{2}。</translation>
    </message>
    <message>
        <source>{0}: the face AIRFOIL is not a non-rational B-spline surface.</source>
        <translation>{0}：面 AIRFOIL 不是非有理 B 样条曲面。</translation>
    </message>
    <message>
        <source>{0}: the field {1} is missing.</source>
        <translation>{0}：缺少字段{1}。</translation>
    </message>
    <message>
        <source>{0}: the file cannot be read: {1}.</source>
        <translation>{0}：文件无法读取：{1}。</translation>
    </message>
    <message>
        <source>{0}: the file cannot be written: {1}.</source>
        <translation>{0}：文件无法写入：{1}。</translation>
    </message>
    <message>
        <source>{0}: the file has a header line but no points.</source>
        <translation>{0}：文件有标题行但没有点。</translation>
    </message>
    <message>
        <source>{0}: the file has {1} GB, at most {2} GB can be read. Thin the cloud.</source>
        <translation>{0}：文件有{1} GB，最多可读取{2} GB。请精简点云。</translation>
    </message>
    <message>
        <source>{0}: the file has {1} MB, expected at most {2} MB.</source>
        <translation>{0}：文件有{1} MB，最多应为{2} MB。</translation>
    </message>
    <message>
        <source>{0}: the file holds no faces.</source>
        <translation>{0}：文件中没有面。</translation>
    </message>
    <message>
        <source>{0}: the file holds no lines with numbers, expected x y z per line.</source>
        <translation>{0}：文件中没有含数字的行，应为每行 x y z。</translation>
    </message>
    <message>
        <source>{0}: the file holds no points.</source>
        <translation>{0}：文件中没有点。</translation>
    </message>
    <message>
        <source>{0}: the file is empty, expected a point cloud.</source>
        <translation>{0}：文件为空，应为点云。</translation>
    </message>
    <message>
        <source>{0}: the file is empty.</source>
        <translation>{0}：文件为空。</translation>
    </message>
    <message>
        <source>{0}: the file is empty; expected a STEP file.</source>
        <translation>{0}：文件为空；应为 STEP 文件。</translation>
    </message>
    <message>
        <source>{0}: the file is not what was written. Export again, and see who else writes there.</source>
        <translation>{0}：文件与写出的内容不符。请重新导出，并查看还有谁在那里写文件。</translation>
    </message>
    <message>
        <source>{0}: the first line says {1} points, the file holds {2}. The file is cut short or its first line is wrong.</source>
        <translation>{0}：第一行声明{1}个点，文件包含{2}个。文件被截断或第一行有误。</translation>
    </message>
    <message>
        <source>{0}: the folder cannot be made ({1}).</source>
        <translation>{0}：文件夹无法创建（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the folder of the clouds cannot be written ({1}).</source>
        <translation>{0}：点云文件夹无法写入（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the folder {1} does not exist. Create it first.</source>
        <translation>{0}：文件夹{1}不存在。请先创建。</translation>
    </message>
    <message>
        <source>{0}: the folder {1} is not writable.</source>
        <translation>{0}：文件夹{1}不可写。</translation>
    </message>
    <message>
        <source>{0}: the header gives {1} as {2}, expected a whole number.</source>
        <translation>{0}：文件头给出的{1}为{2}，应为整数。</translation>
    </message>
    <message>
        <source>{0}: the header says {1} points, the file holds {2}{3}. The file is cut short or its header is wrong.</source>
        <translation>{0}：文件头声明{1}个点，文件包含{2}{3}。文件被截断或文件头有误。</translation>
    </message>
    <message>
        <source>{0}: the header says {1} vertices and {2} other elements, the file has {3} more lines. The header does not describe this file.</source>
        <translation>{0}：文件头声明{1}个顶点和{2}个其他元素，文件还多出{3}行。文件头与该文件不符。</translation>
    </message>
    <message>
        <source>{0}: the header says {1} vertices of {2} bytes, the file holds {3}. The file is cut short or its header is wrong.</source>
        <translation>{0}：文件头声明{1}个{2}字节的顶点，文件包含{3}个。文件被截断或文件头有误。</translation>
    </message>
    <message>
        <source>{0}: the header says {1} vertices, the file holds {2}. The file is cut short or its header is wrong.</source>
        <translation>{0}：文件头声明{1}个顶点，文件包含{2}个。文件被截断或文件头有误。</translation>
    </message>
    <message>
        <source>{0}: the last row must be 0 0 0 1, found {1}.{2}</source>
        <translation>{0}：最后一行必须为 0 0 0 1，现为{1}。{2}</translation>
    </message>
    <message>
        <source>{0}: the list element {1} stands before the vertices, which is not supported. Write the vertices first.</source>
        <translation>{0}：列表元素{1}位于顶点之前，不支持。请先写顶点。</translation>
    </message>
    <message>
        <source>{0}: the low end must be below the high end, found {1}.</source>
        <translation>{0}：下端必须小于上端，现为{1}。</translation>
    </message>
    <message>
        <source>{0}: the matrix contains NaN or infinite numbers.</source>
        <translation>{0}：矩阵含有 NaN 或无穷大。</translation>
    </message>
    <message>
        <source>{0}: the program cannot be read back ({1}).</source>
        <translation>{0}：程序无法回读（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the rotation part is left-handed or singular (determinant {1}, expected +1). Check for swapped or mirrored axes.</source>
        <translation>{0}：旋转部分是左手系或奇异的（行列式{1}，应为 +1）。请检查轴是否互换或镜像。</translation>
    </message>
    <message>
        <source>{0}: the rotation part is scaled (axis lengths {1}, {2}, {3}, expected 1). Give a pure rotation.</source>
        <translation>{0}：旋转部分有缩放（轴长{1}、{2}、{3}，应为 1）。请给出纯旋转。</translation>
    </message>
    <message>
        <source>{0}: the session cannot be written here ({1}). Open it read-only, or copy the folder to where you may write.</source>
        <translation>{0}：会话不能在此写入（{1}）。请以只读方式打开，或将文件夹复制到可写的位置。</translation>
    </message>
    <message>
        <source>{0}: the session does not say its {1}. It is not one of a commissioning.</source>
        <translation>{0}：会话没有说明其{1}。它不是调试会话。</translation>
    </message>
    <message>
        <source>{0}: the session has been closed. Open it again.</source>
        <translation>{0}：会话已关闭。请重新打开。</translation>
    </message>
    <message>
        <source>{0}: the session has no sample &apos;{1}&apos; of the step &apos;{2}&apos;; it is not whole. Take the session from where it was copied, or run the step again.</source>
        <translation>{0}：会话中没有步骤“{2}”的样本“{1}”；会话不完整。请从复制来源取得会话，或重新运行该步骤。</translation>
    </message>
    <message>
        <source>{0}: the session is being written by {1}. Close it there first, or open it read-only.</source>
        <translation>{0}：会话正由{1}写入。请先在那里关闭，或以只读方式打开。</translation>
    </message>
    <message>
        <source>{0}: the session was opened read-only. Open it for writing to change it.</source>
        <translation>{0}：会话以只读方式打开。要更改，请以可写方式打开。</translation>
    </message>
    <message>
        <source>{0}: the session&apos;s cell file is missing. Copy the whole folder again.</source>
        <translation>{0}：会话的单元文件缺失。请重新复制整个文件夹。</translation>
    </message>
    <message>
        <source>{0}: the session&apos;s inputs cannot be written ({1}).</source>
        <translation>{0}：会话的输入无法写入（{1}）。</translation>
    </message>
    <message>
        <source>{0}: the state of the simulated cell cannot be read ({1}). Remove the file; the simulated cell then begins anew.</source>
        <translation>{0}：模拟单元的状态无法读取（{1}）。请删除该文件；模拟单元随后会重新开始。</translation>
    </message>
    <message>
        <source>{0}: the text is UTF-16; save it as UTF-8.</source>
        <translation>{0}：文本为 UTF-16；请保存为 UTF-8。</translation>
    </message>
    <message>
        <source>{0}: the translation is only {1} long, expected mm. It looks like metres: multiply by 1000.</source>
        <translation>{0}：平移只有{1}长，单位应为 mm。看起来单位是米：请乘以 1000。</translation>
    </message>
    <message>
        <source>{0}: the vertices have a list property {1}, which is not supported.</source>
        <translation>{0}：顶点有列表属性{1}，不支持。</translation>
    </message>
    <message>
        <source>{0}: the vertices lack {1}; their properties are {2}.</source>
        <translation>{0}：顶点缺少{1}；其属性为{2}。</translation>
    </message>
    <message>
        <source>{0}: there is a session already. Choose another folder or open that one.</source>
        <translation>{0}：那里已有会话。请选择其他文件夹，或打开那个会话。</translation>
    </message>
    <message>
        <source>{0}: there is no file {1}.</source>
        <translation>{0}：没有文件{1}。</translation>
    </message>
    <message>
        <source>{0}: there is no such file.</source>
        <translation>{0}：没有这个文件。</translation>
    </message>
    <message>
        <source>{0}: this is a folder, expected a file.</source>
        <translation>{0}：这是文件夹，应为文件。</translation>
    </message>
    <message>
        <source>{0}: this is a folder, expected a point cloud file.</source>
        <translation>{0}：这是文件夹，应为点云文件。</translation>
    </message>
    <message>
        <source>{0}: this is a folder, expected the name of a file to write.</source>
        <translation>{0}：这是文件夹，应为要写出的文件名。</translation>
    </message>
    <message>
        <source>{0}: this is no list of chosen faces. Remove the file to begin anew.</source>
        <translation>{0}：这不是所选面的列表。请删除该文件以重新开始。</translation>
    </message>
    <message>
        <source>{0}: this is not a session&apos;s database ({1}).</source>
        <translation>{0}：这不是会话的数据库（{1}）。</translation>
    </message>
    <message>
        <source>{0}: this is not an ordinary file and cannot be replaced.</source>
        <translation>{0}：这不是普通文件，不能替换。</translation>
    </message>
    <message>
        <source>{0}: this is not an ordinary file, expected a point cloud file.</source>
        <translation>{0}：这不是普通文件，应为点云文件。</translation>
    </message>
    <message>
        <source>{0}: this is not an ordinary file.</source>
        <translation>{0}：这不是普通文件。</translation>
    </message>
    <message>
        <source>{0}: unknown key in the path job.</source>
        <translation>{0}：路径作业中有未知的键。</translation>
    </message>
    <message>
        <source>{0}: unknown table [{1}]; expected {2}.</source>
        <translation>{0}：未知的表 [{1}]；应为{2}。</translation>
    </message>
    <message>
        <source>{0}: wheel centre, uncertainty (k = 2)</source>
        <translation>{0}：轮心，不确定度（k = 2）</translation>
    </message>
    <message>
        <source>{0}: {1} can&apos;t be used for registration. {2}</source>
        <translation>{0}：{1}不能用于配准。{2}</translation>
    </message>
    <message>
        <source>{0}: {1} cannot be read: {2}.</source>
        <translation>{0}：{1}无法读取：{2}。</translation>
    </message>
    <message>
        <source>{0}: {1} faces are named {2} (ids {3}). Choose one by its id.</source>
        <translation>{0}：有{1}个面名为{2}（编号{3}）。请按编号选择。</translation>
    </message>
    <message>
        <source>{0}: {1} facets need {2} vertices and an endsolid line, found {3} vertices and {4} endsolid line. The file is cut short or damaged.</source>
        <translation>{0}：{1}个三角面需要{2}个顶点和一行 endsolid，现有{3}个顶点和{4}行 endsolid。文件被截断或损坏。</translation>
    </message>
    <message>
        <source>{0}: {1} has a number with too many digits or is nested too deeply, expected a result.</source>
        <translation>{0}：{1}中有位数过多的数字或嵌套过深，应为结果。</translation>
    </message>
    <message>
        <source>{0}: {1} has neither &apos;{2}&apos; nor &apos;matrix&apos;.</source>
        <translation>{0}：{1}既没有“{2}”也没有“matrix”。</translation>
    </message>
    <message>
        <source>{0}: {1} holds a rejected result. Repeat that step before planning a path.</source>
        <translation>{0}：{1}中的结果是被拒绝的。规划路径前请重做该步骤。</translation>
    </message>
    <message>
        <source>{0}: {1} is a {2}, expected a B-spline surface (the airfoil).</source>
        <translation>{0}：{1}是{2}，应为 B 样条曲面（叶身）。</translation>
    </message>
    <message>
        <source>{0}: {1} is named twice in the list of faces.</source>
        <translation>{0}：{1}在面的列表中出现两次。</translation>
    </message>
    <message>
        <source>{0}: {1} is not JSON ({2}).</source>
        <translation>{0}：{1}不是 JSON（{2}）。</translation>
    </message>
    <message>
        <source>{0}: {H} turned against the drawing about {1} of {B}</source>
        <translation>{0}：{H} 相对图纸绕 {B} 的{1}的转角</translation>
    </message>
    <message>
        <source>{0}?mode={1}</source>
        <translation>{0}?mode={1}</translation>
    </message>
    <message>
        <source>{0}[{1}]: the point contains NaN or infinite numbers. Pick it again.</source>
        <translation>{0}[{1}]：该点含有 NaN 或无穷大。请重新选取。</translation>
    </message>
</context>
</TS>
