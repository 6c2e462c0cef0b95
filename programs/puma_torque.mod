MODULE puma_torque
  ! A PUMA 560 hands parts of 2 kg from a press to a tray, arm stretched, and back beside its column, arm folded.
  PERS tooldata gripper := [TRUE,[[0,0,110],[1,0,0,0]],[0.8,[0,0,45],[1,0,0,0],0.001,0.001,0.0008]];
  PERS loaddata part := [2,[0,0,20],[1,0,0,0],0.003,0.003,0.002];

  CONST jointtarget home := [[0,-60,120,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget press := [[650,-150,600],[0,0,1,0],[-1,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget tray := [[650,350,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget near_in := [[380,-50,700],[0,0,1,0],[-1,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
  CONST robtarget near_out := [[380,350,700],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

  PROC main()
    ConfJ \Off;
    ConfL \Off;
    ! stretched, with the part
    MoveJ Offs(press,0,0,120), vmax, fine, gripper;
    MoveL press, vmax, fine, gripper;
    GripLoad part;
    WaitTime 0.1;
    MoveL Offs(press,0,0,120), vmax, z20, gripper;
    MoveJ Offs(tray,0,0,120), vmax, fine, gripper;
    MoveL tray, vmax, fine, gripper;
    GripLoad load0;
    WaitTime 0.1;
    MoveL Offs(tray,0,0,120), vmax, z20, gripper;
    ! folded, empty
    MoveJ near_out, vmax, fine, gripper;
    MoveJ near_in, vmax, fine, gripper;
    MoveAbsJ home, vmax, fine, gripper;
  ENDPROC
ENDMODULE
