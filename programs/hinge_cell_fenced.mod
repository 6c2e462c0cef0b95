MODULE HingeCellFenced
    ! The hinge cell with what stands in it: a column between stations 1 and 2, a fence behind the rail, tables under
    ! the stations. The gripper is 100 mm long. Straight joint moves hit the column: there are ways around it.
    ! An IRB 140 on a rail takes a hinge out of station 1 and carries it to stations 2 and 3.
    ! The rail (external axis a, mm) drives along the world's y and carries the base, so a robtarget
    ! keeps its place in the world whatever its eax_a says. The tool points straight down.

    PERS tooldata tHinge:=[TRUE,[[0,0,100],[1,0,0,0]],[1.1,[0,0,45],[1,0,0,0],0,0,0]];

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];

    ! Station 1: the part waits at y = 200 mm.
    CONST robtarget p_n1_in:=[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n1:=[[500,200,330],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n1_out:=[[500,200,450],[0,0,1,0],[0,0,0,0],[200,9E9,9E9,9E9,9E9,9E9]];

    ! Station 2: riveted in the gripper at y = 1350 mm.
    CONST robtarget p_n2_in:=[[500,1350,450],[0,0,1,0],[0,0,0,0],[1350,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n2:=[[500,1350,330],[0,0,1,0],[0,0,0,0],[1350,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n2_out:=[[500,1350,450],[0,0,1,0],[0,0,0,0],[1350,9E9,9E9,9E9,9E9,9E9]];

    ! Station 3: 70 mm higher and turned by 45 degrees about the vertical, at y = 1900 mm.
    CONST robtarget p_n3_in:=[[500,1900,520],[0,0.3826834,0.9238795,0],[0,0,0,0],[1900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n3:=[[500,1900,400],[0,0.3826834,0.9238795,0],[0,0,0,0],[1900,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_n3_out:=[[500,1900,520],[0,0.3826834,0.9238795,0],[0,0,0,0],[1900,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        ! The cycle begins and ends at home, at rest.
        ServeStation1;
        ServeStation2;
        ServeStation3;
        MoveAbsJ j_home, v2500, fine, tHinge;
    ENDPROC

    PROC ServeStation1()
        MoveJ p_n1_in, v2500, fine, tHinge \WObj:=wobj0;
        MoveL p_n1, v500, fine, tHinge \WObj:=wobj0;
        WaitTime 0.3; ! the gripper closes
        MoveL p_n1_out, v500, fine, tHinge \WObj:=wobj0;
    ENDPROC

    PROC ServeStation2()
        MoveJ p_n2_in, v2500, fine, tHinge \WObj:=wobj0;
        MoveL p_n2, v500, fine, tHinge \WObj:=wobj0;
        WaitTime 0.8; ! riveting; the part stays in the gripper
        MoveL p_n2_out, v500, fine, tHinge \WObj:=wobj0;
    ENDPROC

    PROC ServeStation3()
        MoveJ p_n3_in, v2500, fine, tHinge \WObj:=wobj0;
        MoveL p_n3, v500, fine, tHinge \WObj:=wobj0;
        WaitTime 0.8; ! riveting, then the station takes the part
        MoveL p_n3_out, v500, fine, tHinge \WObj:=wobj0;
    ENDPROC
ENDMODULE
