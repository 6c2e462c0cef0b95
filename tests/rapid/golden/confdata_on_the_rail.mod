MODULE ConfdataOnTheRail
    ! The rail carries the base along y. At 1000 mm the point stands straight ahead, at 0 it is out of reach.
    CONST robtarget p_with:=[[450,1000,647],[0,0,1,0],[0,0,0,0],[1000,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_open:=[[450,1000,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j_home:=[[0,0,0,0,30,0],[0,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_with, v500, fine, tool0;
        MoveL p_open, v500, fine, tool0;
        MoveAbsJ j_home, v500, fine, tool0;
        MoveJ p_open, v500, fine, tool0;
    ENDPROC
ENDMODULE
