MODULE Positioner
    ! Seams on three sides of a box on a turntable (unit STN1, external axis b, deg) beside the rail (external axis a,
    ! mm). The work object rides on the table: targets are given on the box, and each side is turned to the robot. The
    ! table turns while the robot moves from side to side by MoveJ, and once by itself at the end.
    PERS wobjdata wobj_box:=[FALSE,FALSE,"STN1",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_table_back:=[[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,0,9E9,9E9,9E9,9E9]];

    ! The front side, the table at 0.
    CONST robtarget p_front_off:=[[-160,-90,330],[0,0,1,0],[-1,0,-1,0],[500,0,9E9,9E9,9E9,9E9]];
    CONST robtarget p_front_1:=[[-120,-90,200],[0,0,1,0],[-1,0,-1,0],[500,0,9E9,9E9,9E9,9E9]];
    CONST robtarget p_front_2:=[[-120,90,200],[0,0,1,0],[0,0,0,0],[500,0,9E9,9E9,9E9,9E9]];

    ! The left side, the table at 90.
    CONST robtarget p_left_off:=[[-90,160,330],[0,0.7071068,0.7071068,0],[-1,0,-1,0],[500,90,9E9,9E9,9E9,9E9]];
    CONST robtarget p_left_1:=[[-90,120,200],[0,0.7071068,0.7071068,0],[-1,0,-1,0],[500,90,9E9,9E9,9E9,9E9]];
    CONST robtarget p_left_2:=[[90,120,200],[0,0.7071068,0.7071068,0],[0,0,0,0],[500,90,9E9,9E9,9E9,9E9]];

    ! The right side, the table at -90.
    CONST robtarget p_right_off:=[[90,-160,330],[0,-0.7071068,0.7071068,0],[-1,0,-1,0],[500,-90,9E9,9E9,9E9,9E9]];
    CONST robtarget p_right_1:=[[90,-120,200],[0,-0.7071068,0.7071068,0],[-1,0,-1,0],[500,-90,9E9,9E9,9E9,9E9]];
    CONST robtarget p_right_2:=[[-90,-120,200],[0,-0.7071068,0.7071068,0],[0,0,0,0],[500,-90,9E9,9E9,9E9,9E9]];

    PROC main()
        Seam p_front_off, p_front_1, p_front_2;
        Seam p_left_off, p_left_1, p_left_2;
        Seam p_right_off, p_right_1, p_right_2;
        MoveAbsJ j_home, v1000, fine, tool0;
        MoveExtJ j_table_back, vrot100, fine;
    ENDPROC

    PROC Seam(robtarget off, robtarget first, robtarget last)
        MoveJ off, v1000, fine, tool0 \WObj:=wobj_box;
        MoveL first, v500, fine, tool0 \WObj:=wobj_box;
        MoveL last, v100, fine, tool0 \WObj:=wobj_box;
        MoveL off, v500, fine, tool0 \WObj:=wobj_box;
    ENDPROC
ENDMODULE
