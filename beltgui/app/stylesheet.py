"""The application's stylesheet, made from a theme's colours and sizes.

Widgets ask for a look by dynamic properties, not by colours of their own:

- `primary` = true: the one button that is the next thing to do; at least 44 px high.
- `stop` = true: the large red button.
- `quiet` = true: a button without a frame.
- `panel` = true: a framed surface on the background.
- `tone` = good / bad / warn / muted / accent: the colour of a label's text.
- `banner` = good / bad / warn / info: a label or frame on a pale ground with a strong left edge.
- `title` = 1 / 2: a heading.
- `link` = true: a small tool button that looks like a link.
"""

from __future__ import annotations

from collections.abc import Callable

from resources import resource_path

SHEET = """
QToolTip {{ color: {text}; background: {panel}; border: 1px solid {line}; padding: {p4}px; }}
QFrame[panel="true"], QWidget[panel="true"] {{
    background: {panel}; border: 1px solid {line}; border-radius: {p6}px; }}
QFrame[panel="true"] QLabel {{ border: none; background: transparent; }}
QLabel[title="1"] {{ font-size: {p22}px; font-weight: 600; }}
QLabel[title="2"] {{ font-size: {p16}px; font-weight: 600; }}
QLabel[tone="good"] {{ color: {good}; }}
QLabel[tone="bad"] {{ color: {bad}; }}
QLabel[tone="warn"] {{ color: {warn}; }}
QLabel[tone="muted"] {{ color: {muted}; }}
QLabel[tone="accent"] {{ color: {accent}; }}
*[banner="good"] {{ background: {good_surface}; color: {text}; border: none; border-left: {p6}px solid {good};
    padding: {p6}px; }}
*[banner="bad"] {{ background: {bad_surface}; color: {text}; border: none; border-left: {p6}px solid {bad};
    padding: {p6}px; }}
*[banner="warn"] {{ background: {warn_surface}; color: {text}; border: none; border-left: {p6}px solid {warn};
    padding: {p6}px; }}
*[banner="info"] {{ background: {panel}; color: {text}; border: none; border-left: {p6}px solid {muted};
    padding: {p6}px; }}
QPushButton, QToolButton {{ background: {panel}; color: {text}; border: 1px solid {line}; border-radius: {p4}px;
    padding: {p4}px {p10}px; min-height: {p20}px; }}
QPushButton:hover, QToolButton:hover {{ background: {hover}; }}
QPushButton:pressed, QToolButton:pressed, QPushButton:checked, QToolButton:checked {{
    background: {hover}; border-color: {accent}; }}
QPushButton:focus, QToolButton:focus {{ border: 2px solid {accent}; }}
QPushButton:disabled, QToolButton:disabled {{ color: {muted}; background: {background}; }}
QPushButton[quiet="true"], QToolButton[quiet="true"] {{ border-color: transparent; background: transparent; }}
QPushButton[quiet="true"]:focus, QToolButton[quiet="true"]:focus {{ border: 2px solid {accent}; }}
QToolButton[link="true"] {{ background: transparent; color: {accent}; border: 1px solid transparent;
    padding: 0 {p4}px; min-height: {p20}px; }}
QToolButton[link="true"]:hover {{ text-decoration: underline; }}
QToolButton[link="true"]:focus {{ border: 1px solid {accent}; }}
QPushButton[primary="true"] {{ background: {accent}; color: {on_accent}; border: 2px solid {accent};
    font-weight: 600; font-size: {p15}px; min-height: {p34}px; padding: {p4}px {p16}px; }}
QPushButton[primary="true"]:focus {{ border: 2px solid {text}; }}
QPushButton[primary="true"]:disabled {{ background: {background}; color: {muted}; border: 1px solid {line}; }}
QPushButton[stop="true"] {{ background: {stop}; color: {on_stop}; border: 2px solid {stop}; border-radius: {p6}px;
    font-weight: 700; font-size: {p20}px; min-height: {p40}px; min-width: {p110}px; }}
QPushButton[stop="true"]:focus, QPushButton[stop="true"]:hover {{ border: 2px solid {text}; }}
QLineEdit, QComboBox, QSpinBox, QDoubleSpinBox, QPlainTextEdit, QTextBrowser {{
    background: {panel}; color: {text}; border: 1px solid {line}; border-radius: {p4}px; padding: {p4}px;
    selection-background-color: {accent}; selection-color: {on_accent}; }}
QLineEdit:focus, QComboBox:focus, QSpinBox:focus, QDoubleSpinBox:focus, QPlainTextEdit:focus, QTextBrowser:focus {{
    border: 2px solid {accent}; }}
QComboBox::drop-down {{ border: none; width: {p20}px; }}
QComboBox::down-arrow {{ image: url({down}); width: {p10}px; height: {p10}px; }}
QComboBox QAbstractItemView {{ background: {panel}; color: {text}; selection-background-color: {accent};
    selection-color: {on_accent}; }}
QHeaderView::section {{ background: {background}; color: {text}; border: none; border-right: 1px solid {line};
    border-bottom: 1px solid {line}; padding: {p4}px; }}
QTableView, QListView, QTreeView {{ background: {panel}; color: {text}; border: 1px solid {line};
    gridline-color: {line}; selection-background-color: {accent}; selection-color: {on_accent}; }}
QProgressBar {{ background: {background}; color: {text}; border: 1px solid {line}; border-radius: {p4}px;
    text-align: center; min-height: {p16}px; }}
QProgressBar::chunk {{ background: {line}; border-radius: {p4}px; }}
QStatusBar {{ background: {background}; }}
QStatusBar::item {{ border: none; }}
QMenuBar {{ background: {background}; color: {text}; }}
QMenuBar::item {{ padding: {p4}px {p8}px; background: transparent; }}
QMenuBar::item:selected {{ background: {hover}; }}
QMenu {{ background: {panel}; color: {text}; border: 1px solid {line}; padding: {p4}px; }}
QMenu::item {{ padding: {p4}px {p22}px; }}
QMenu::item:selected {{ background: {accent}; color: {on_accent}; }}
QMenu::item:disabled {{ color: {muted}; }}
QMenu::separator {{ height: 1px; background: {line}; margin: {p4}px; }}
QTabBar::tab {{ background: {background}; color: {text}; border: 1px solid {line}; padding: {p4}px {p10}px; }}
QTabBar::tab:selected {{ background: {panel}; border-bottom: 2px solid {accent}; }}
QTabWidget::pane {{ border: 1px solid {line}; }}
QDockWidget {{ color: {text}; }}
QDockWidget::title {{ background: {background}; padding: {p6}px; }}
QSplitter::handle {{ background: {line}; }}
QScrollArea {{ border: none; background: transparent; }}
QCheckBox, QRadioButton {{ spacing: {p8}px; min-height: {p22}px; }}
QCheckBox:focus, QRadioButton:focus {{ color: {accent}; }}
QCheckBox::indicator, QRadioButton::indicator, QAbstractItemView::indicator {{
    width: {p16}px; height: {p16}px; border: 1px solid {muted}; background: {panel}; }}
QCheckBox::indicator, QAbstractItemView::indicator {{ border-radius: {p4}px; }}
QRadioButton::indicator {{ border-radius: {radio}px; }}
QCheckBox::indicator:hover, QRadioButton::indicator:hover, QCheckBox::indicator:focus, QRadioButton::indicator:focus {{
    border: 2px solid {accent}; width: {inner}px; height: {inner}px; }}
QCheckBox::indicator:checked, QAbstractItemView::indicator:checked {{
    background: {accent}; border-color: {accent}; image: url({tick}); }}
QRadioButton::indicator:checked {{ border: {p5}px solid {accent}; background: {panel};
    width: {p8}px; height: {p8}px; }}
QCheckBox::indicator:disabled, QRadioButton::indicator:disabled, QAbstractItemView::indicator:disabled {{
    border-color: {line}; background: {background}; }}
QCheckBox::indicator:checked:disabled, QAbstractItemView::indicator:checked:disabled {{
    background: {muted}; border-color: {muted}; }}
QDialog {{ border: 1px solid {muted}; }}
"""

SIZES = (4, 5, 6, 8, 10, 15, 16, 20, 22, 34, 40, 110)


def stylesheet(name: str, colours: dict[str, str], px: Callable[[float], int]) -> str:
    """The stylesheet of a theme.

    Args:
        name: `light` or `dark`.
        colours: Of the theme.
        px: Gives a size in pixels.
    """
    words = {key.replace(" ", "_"): value for key, value in colours.items()}
    pictures = {key: resource_path("pictures", f"{key}_{name}.svg").as_posix() for key in ("tick", "down")}
    return SHEET.format(**words, **pictures, **{f"p{size}": px(size) for size in SIZES}, inner=px(16) - 2,
                        radio=(px(16) + 2) // 2)  # fmt: skip
