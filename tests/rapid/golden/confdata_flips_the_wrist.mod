MODULE ConfdataFlipsTheWrist
    ! The tool straight down with joint 5 at 90 deg; cfx 1 has it at -90, joints 4 and 6 half a turn further.
    CONST robtarget p_near:=[[450,0,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_far:=[[450,100,647],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_flip:=[[450,100,647],[0,0,1,0],[0,-2,-2,1],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p_near, v500, fine, tool0;
        MoveL p_far, v500, fine, tool0;
        MoveL p_near, v500, fine, tool0;
        MoveL p_flip, v500, fine, tool0;
        MoveJ p_near, v500, fine, tool0;
        MoveJ p_flip, v500, fine, tool0; ! a joint move may
    ENDPROC
ENDMODULE
