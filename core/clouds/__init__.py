"""Point clouds from files: PLY, PCD, text and STL, read in full or refused with a sentence."""

from core.clouds.cloud import Cloud
from core.clouds.reader import SUPPORTED_ENDINGS, read_cloud

__all__ = ["SUPPORTED_ENDINGS", "Cloud", "read_cloud"]
