MODULE ConfdataOff
    CONST robtarget p_near:=[[450,0,647],[0,0,1,0],[3,3,3,7],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p_far:=[[450,100,647],[0,0,1,0],[0,-2,-2,1],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        ConfJ\Off;
        ConfL\Off;
        MoveJ p_near, v500, fine, tool0;
        MoveL p_far, v500, fine, tool0;
        ConfJ\On;
        MoveL p_near, v500, fine, tool0;
    ENDPROC
ENDMODULE
