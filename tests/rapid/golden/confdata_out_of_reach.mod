MODULE ConfdataOutOfReach
    ! Joints [0,0,0,0,90,0]: the tool straight down at [450,0,647], every angle in its first quadrant.
    CONST robtarget p_good:=[[450,0,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_turned:=[[450,0,647],[0,0,1,0],[0,0,2,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_far:=[[900,0,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_good, v500, fine, tool0;
        MoveJ p_turned, v500, fine, tool0;
        MoveJ p_far, v500, fine, tool0;
        MoveJ p_good, v500, fine, tool0;
    ENDPROC
ENDMODULE
