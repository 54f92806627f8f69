import pytest

from semref.core.errors import ParameterError
from semref.core.flight.cameras import complete_camera, merge_camera, read_cameras
from semref.core.geometry.camera import Camera, Lens, above_ground, above_takeoff
from semref.core.geometry.leveling import Attitude

PHOTO = Camera(Attitude(1, 2), Lens("field_of_view", 60, 1.5), "a.jpg", 7.0, None, above_takeoff(50), 90.0)


@pytest.fixture
def table(tmp_path):
    def write(text):
        (tmp_path / "cameras.csv").write_text(text, encoding="utf-8")
        return str(tmp_path / "cameras.csv")

    return write


def test_the_table_counts_before_the_photo():
    row = Camera(Attitude(5, 6), Lens("focal_length_px", 800), "cameras.csv", 3.0, None, above_ground(100), 0.0)
    assert merge_camera(row, PHOTO, is_timed=True) == row
    assert merge_camera(Camera(), PHOTO, is_timed=False) == PHOTO
    assert merge_camera(Camera(heading_deg=0.0), PHOTO, is_timed=True).heading_deg == 0.0
    assert merge_camera(Camera(), PHOTO, is_timed=True).time_s is None


def test_a_log_fills_what_table_and_photo_lack():
    log = Camera(Attitude(8, 9), height=above_takeoff(70), heading_deg=33.0)
    assert complete_camera(PHOTO, log, with_attitude=True) == PHOTO
    found = complete_camera(Camera(lens=PHOTO.lens), log, with_attitude=True)
    assert found == Camera(log.attitude, PHOTO.lens, height=log.height, heading_deg=33.0)
    assert complete_camera(Camera(), log, with_attitude=False).attitude is None


def test_a_table_is_read_by_names_without_folders_and_extensions(table):
    path = table("image;roll;pitch;focal_length_px;height;heading\nb.JPG;1;2;900;100;-30\n\na;;;;;10\n")
    one, other, third = read_cameras(["/x/a.png", "b.tif", "c.png"], path)
    assert (one.heading_deg, one.attitude) == (10, None)
    assert (other.attitude.roll_deg, other.lens.value, other.heading_deg) == (1, 900, 330)
    assert third == Camera()


@pytest.mark.parametrize(
    ("text", "message"),
    [
        ("", "is not a camera table"),
        ("image\na\n", "is not a camera table. Its header is “image”"),
        ("roll,pitch\n1,2\n", "needs the column image"),
        ("image,roll,pitch\na,1,\n", "line 2: roll or pitch is empty"),
        ("image,roll,pitch\na,x,2\n", "line 2: roll is “x”, which is not a number"),
        ("image,roll,pitch\na,0,-90\n", "line 2: A camera with a pitch of -90° does not look at the ground"),
        ("image,focal_length_px,field_of_view\na,1000,60\n", "describe the same lens"),
        ("image,field_of_view\na,180\n", "field_of_view is 180, which is impossible"),
        ("image,focal_length_px\na,-5\n", "focal_length_px is -5, which is impossible"),
        ("image,roll,pitch\na,1,2\na.jpg,1,3\n", "line 3: the image a has a row already"),
        ("image,roll,pitch\n,1,2\n", "line 2: the image is missing"),
        ("image,time\na,noon\n", "line 2: time is “noon”. Enter seconds"),
        ("image,time\na,nan\n", "line 2: time is “nan”. Enter seconds"),
        ("image,time\na,2025-13-01\n", "line 2: time is “2025-13-01”"),
        ("image,time\na,2025-06-30T10:00:00\nb,12\n", "times in seconds and times with dates"),
        ("image,roll,pitch\nz,1,2\n", "does not contain any of the images, for example a.png"),
        ("image,height\na.png,-5\n", "height is -5, which is impossible"),
        ("image,height\na.png,high\n", "line 2: height is “high”"),
    ],
)
def test_a_mistake_is_one_sentence(table, text, message):
    with pytest.raises(ParameterError) as caught:
        read_cameras(["a.png", "b.png"], table(text))
    assert message in str(caught.value) and str(caught.value).count("cameras.csv") == 1
