MODULE BenchIrb140
    ! An IRB 140 on a bench, no rail: takes three parts from a feeder and sets them on a tray.

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PERS tooldata tGripper:=[TRUE,[[0,0,120],[1,0,0,0]],[1.2,[0,0,60],[1,0,0,0],0,0,0]];
    PERS wobjdata wTray:=[FALSE,TRUE,"",[[380,120,60],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];

    CONST robtarget p_pick:=[[420,-200,120],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_place{3}:=[
        [[0,0,20],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
        [[60,30,20],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
        [[120,60,20],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];

    CONST num lift:=80;
    VAR num placed:=0;

    PROC main()
        Reset do_gripper;
        placed:=0;
        FOR i FROM 1 TO 3 DO
            PickPart;
            PlacePart p_place{i};
        ENDFOR
        IF placed=3 TPWrite "tray full";
        MoveAbsJ j_home\NoEOffs, v1000, fine, tGripper;
    ENDPROC

    PROC PickPart()
        MoveJ RelTool(p_pick,0,0,-lift), v1000, fine, tGripper;
        WaitDI di_part_ready, 1;
        MoveL p_pick, v200, fine, tGripper;
        Set do_gripper;
        WaitTime 0.25; ! the jaws close
        MoveL Offs(p_pick,0,0,lift), v500, z10, tGripper;
    ENDPROC

    PROC PlacePart(robtarget p)
        MoveJ Offs(p,0,0,lift), v1000, fine, tGripper\WObj:=wTray;
        MoveL p, v200, fine, tGripper\WObj:=wTray;
        Reset do_gripper;
        WaitTime\InPos, 0.15; ! the jaws open
        MoveL Offs(p,0,0,lift), v500, fine, tGripper\WObj:=wTray;
        Incr placed;
    ENDPROC
ENDMODULE
