"""Robots: URDF and YAML to a RobotModel; forward, inverse and differential kinematics; CasADi expressions."""
