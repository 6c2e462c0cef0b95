MODULE RoundSeam
    ! A round seam on a turntable (unit STN1, external axis b, deg) beside the rail (external axis a, mm), drawn while
    ! the table turns: two arcs and a line on the work object, which rides on the table, whose targets have different
    ! values for it. What is round or straight is so on the work, and the speeds are those over it.
    PERS wobjdata wobj_disc:=[FALSE,FALSE,"STN1",[[0,0,0],[1,0,0,0]],[[0,0,0],[1,0,0,0]]];

    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_table_back:=[[9E9,9E9,9E9,9E9,9E9,9E9],[9E9,0,9E9,9E9,9E9,9E9]];

    ! Round a disc of 240 mm: 320 deg of its rim, of which the table does 200 and the robot the rest.
    CONST robtarget p_rim_off:=[[122.16,44.46,320],[0,0.9848078,0.1736482,0],[0,0,0,0],[500,100,9E9,9E9,9E9,9E9]];
    CONST robtarget p_rim_1:=[[112.763,41.042,200],[0,0.9848078,0.1736482,0],[0,0,0,0],[500,100,9E9,9E9,9E9,9E9]];
    CONST robtarget p_rim_2:=[[-20.838,118.177,200],[0,0.6427876,0.7660444,0],[0,0,0,0],[500,50,9E9,9E9,9E9,9E9]];
    CONST robtarget p_rim_3:=[[-120,0,200],[0,0,1,0],[0,0,0,0],[500,0,9E9,9E9,9E9,9E9]];
    CONST robtarget p_rim_4:=[[-20.838,-118.177,200],[0,-0.6427876,0.7660444,0],[-1,0,-1,0],[500,-50,9E9,9E9,9E9,9E9]];
    CONST robtarget p_rim_5:=[[112.763,-41.042,200],[0,-0.9848078,0.1736482,0],[-1,0,-1,0],[500,-100,9E9,9E9,9E9,9E9]];

    ! Straight across, the table turning back.
    CONST robtarget p_top_1:=[[-90,0,230],[0,-0.7660444,0.6427876,0],[0,0,0,0],[500,-100,9E9,9E9,9E9,9E9]];
    CONST robtarget p_top_2:=[[90,0,230],[0,-0.1736482,0.9848078,0],[-1,0,-1,0],[500,-20,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_rim_off, v1000, fine, tool0 \WObj:=wobj_disc;
        MoveL p_rim_1, v500, fine, tool0 \WObj:=wobj_disc;
        MoveC p_rim_2, p_rim_3, v100, fine, tool0 \WObj:=wobj_disc;
        MoveC p_rim_4, p_rim_5, v100, fine, tool0 \WObj:=wobj_disc;
        MoveJ p_top_1, v1000, fine, tool0 \WObj:=wobj_disc;
        MoveL p_top_2, v300, fine, tool0 \WObj:=wobj_disc;
        MoveAbsJ j_home, v1000, fine, tool0;
        MoveExtJ j_table_back, vrot100, fine;
    ENDPROC
ENDMODULE
