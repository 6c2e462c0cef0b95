MODULE MachineTending
    ! An IRB 140 takes a blank from a table and puts it into a lathe's chuck, through the lathe's door.
    ! The gripper is 100 mm long. The blank is a part of the cell (attach in the cell file): until the gripper
    ! closes it stands on the table, then it moves with the flange, and after that it stands in the chuck.

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PERS tooldata tGripper:=[TRUE,[[0,0,100],[1,0,0,0]],[1.4,[0,0,50],[1,0,0,0],0,0,0]];

    ! The table stands to the left of the robot; the blank is gripped from above, in its middle.
    CONST robtarget p_table_in:=[[80,560,330],[0,0.7071068,0.7071068,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_table:=[[80,560,230],[0,0.7071068,0.7071068,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    ! The door's opening is in front; the gripper points into it.
    CONST robtarget p_door:=[[450,0,480],[0.7071068,0,0.7071068,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_chuck:=[[750,0,480],[0.7071068,0,0.7071068,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        ConfJ \Off;
        ConfL \Off;
        TakeBlank;
        LoadChuck;
        MoveAbsJ j_home\NoEOffs, v1000, fine, tGripper;
    ENDPROC

    PROC TakeBlank()
        MoveJ p_table_in, v1000, fine, tGripper;
        MoveL p_table, v200, fine, tGripper;
        Set doGripper;
        WaitTime 0.3; ! the jaws close
        MoveL p_table_in, v500, fine, tGripper;
    ENDPROC

    PROC LoadChuck()
        MoveJ p_door, v1000, fine, tGripper;
        MoveL p_chuck, v300, fine, tGripper;
        WaitTime 0.4; ! the chuck closes
        Reset doGripper;
        WaitTime 0.2;
        MoveL p_door, v500, fine, tGripper;
    ENDPROC
ENDMODULE
