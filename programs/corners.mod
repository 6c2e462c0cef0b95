MODULE Corners
    ! An IRB 140 on a bench, no rail: takes two blanks from a chute, shows each to a camera and drops it into a tray.
    ! Most points are passed in corners, between MoveJ, MoveL and MoveAbsJ in every order.

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_lifted:=[[-15,-10,5,0,50,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_swung:=[[15,-5,5,0,55,-15],[9E9,9E9,9E9,9E9,9E9,9E9]];

    ! 40 mm round the tool centre point; the orientation and external axes turn over within 60 mm, 6 degrees and 60 mm.
    CONST zonedata z_wide:=[FALSE,40,60,60,6,60,6];

    PERS tooldata tSucker:=[TRUE,[[0,0,90],[1,0,0,0]],[0.8,[0,0,45],[1,0,0,0],0,0,0]];
    PERS wobjdata wTray:=[FALSE,TRUE,"",[[400,160,40],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];

    CONST robtarget p_chute:=[[430,-220,130],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_camera_in:=[[520,-60,360],[0,0,1,0],[-1,0,-1,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_camera:=[[520,20,320],[0,0.1305262,0.9914449,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_camera_turned:=[[520,40,320],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_camera_out:=[[480,90,360],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_tray{2}:=[
        [[0,0,30],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],
        [[90,0,30],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]]];

    PROC main()
        FOR i FROM 1 TO 2 DO
            TakeBlank;
            ShowBlank;
            DropBlank p_tray{i};
        ENDFOR
        MoveAbsJ j_home\NoEOffs, v1000, fine, tSucker;
    ENDPROC

    PROC TakeBlank()
        MoveAbsJ j_lifted\NoEOffs, v1000, z50, tSucker;
        MoveL Offs(p_chute,0,60,150), v1000, z50, tSucker;
        MoveL Offs(p_chute,0,0,60), v500, z10, tSucker;
        MoveL p_chute, v200, fine, tSucker;
        Set do_vacuum;
        WaitTime 0.2; ! the sucker holds
        MoveL Offs(p_chute,0,0,60), v200, z1, tSucker;
        MoveL Offs(p_chute,0,60,150), v500, z20, tSucker;
    ENDPROC

    PROC ShowBlank()
        MoveJ p_camera_in, v1000, z30, tSucker;
        MoveJ p_camera, v500, z10, tSucker; ! a wait follows: the controller stops here
        WaitTime 0.3; ! the camera looks
        MoveL p_camera_turned, v500\T:=0.5, fine, tSucker; ! half a second, in which the camera looks on
        MoveL p_camera_out, v500, z_wide, tSucker;
        MoveAbsJ j_swung\NoEOffs, v1000, z100, tSucker;
    ENDPROC

    PROC DropBlank(robtarget p)
        MoveJ Offs(p,0,-40,140), v1000, z60, tSucker\WObj:=wTray;
        MoveL Offs(p,0,0,80), v500, z10\Z:=15, tSucker\WObj:=wTray;
        MoveL p, v200, fine, tSucker\WObj:=wTray;
        Reset do_vacuum;
        WaitTime 0.1; ! the blank falls
        MoveL Offs(p,0,0,80), v500, z20, tSucker\WObj:=wTray;
        MoveJ Offs(p,0,-40,140), v1000, z40, tSucker\WObj:=wTray;
        MoveAbsJ j_swung\NoEOffs, v1000, z80, tSucker;
    ENDPROC
ENDMODULE
