"""URDFs made up for these tests: a six-axis arm with an elbow offset, written as loosely as the format allows."""

from __future__ import annotations

from pathlib import Path

LOOSE = """<robot name="loose arm">
  <link name="world"/> <link name="foot"/> <link name="turret"/> <link name="lower"/> <link name="elbow"/>
  <link name="fore"/> <link name="wrist"/> <link name="hand"/> <link name="flange"/>
  <link name="gripper"/> <link name="finger_1"/> <link name="finger_2"/>
  <!-- joints in no order -->
  <joint name="elbow_pitch" type="revolute">
    <parent link="lower"/> <child link="elbow"/> <origin xyz="0 0 0.7"/> <axis xyz="0 -1 0"/>
    <limit lower="-1.2" upper="3.1" velocity="3"/>
  </joint>
  <joint name="base_yaw" type="continuous">
    <parent link="foot"/> <child link="turret"/> <origin xyz="0 0 0.4"/> <axis xyz="0 0 1"/> <limit velocity="3"/>
  </joint>
  <joint name="stand" type="fixed"> <parent link="world"/> <child link="foot"/> <origin xyz="0 0 0.5"/> </joint>
  <joint name="shoulder_pitch" type="revolute">
    <parent link="turret"/> <child link="lower"/> <origin xyz="0.15 0 0"/> <axis xyz="0 2 0"/>
    <limit lower="-1.6" upper="2.6" velocity="3" effort="900"/>
    <safety_controller soft_lower_limit="-1.5" soft_upper_limit="2.5" k_velocity="1"/>
  </joint>
  <joint name="fore_roll" type="revolute">
    <parent link="elbow"/> <child link="fore"/> <origin xyz="0.3 0 0.1"/>
    <limit lower="-3.4" upper="3.4" velocity="4"/>
  </joint>
  <joint name="wrist_pitch" type="revolute">
    <parent link="fore"/> <child link="wrist"/> <origin xyz="0.5 0 0"/> <axis xyz="0 1 0"/>
    <limit lower="-2" upper="2" velocity="4"/>
  </joint>
  <joint name="hand_roll" type="revolute">
    <parent link="wrist"/> <child link="hand"/> <axis/>
    <limit lower="-6" upper="6" velocity="6"/>
  </joint>
  <joint name="face" type="fixed">
    <parent link="hand"/> <child link="flange"/> <origin xyz="0.1 0 0" rpy="0 1.5708 0"/>
  </joint>
  <joint name="grip" type="fixed"> <parent link="flange"/> <child link="gripper"/> </joint>
  <joint name="open" type="prismatic">
    <parent link="gripper"/> <child link="finger_1"/> <limit upper="0.1" velocity="1"/>
  </joint>
  <joint name="close" type="prismatic">
    <parent link="gripper"/> <child link="finger_2"/> <limit upper="0.1" velocity="1"/>
    <mimic joint="open" multiplier="-1"/>
  </joint>
</robot>
"""


def written(folder: Path, edits: dict[str, str] | None = None, name: str = "model.urdf", text: str = LOOSE) -> Path:
    """The loose arm with every occurrence of the edits' keys replaced, as a file."""
    for old, new in (edits or {}).items():
        assert old in text, old
        text = text.replace(old, new)
    path = folder / name
    path.write_text(text, encoding="utf-8")
    return path
