MODULE LineLengths
    CONST robtarget p:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];

    PROC main()
        MoveJ p, v500, fine, tool0;
        MoveL Offs(p,30,40,0), v100, fine, tool0;
        MoveL Offs(p,30,40,-120), v100, fine, tool0;
        MoveAbsJ j, v500, fine, tool0;
        MoveL p, v100, fine, tool0; ! from a place that only the robot knows
        MoveL Offs(p,0,0,-7.5), v100, fine, tool0;
    ENDPROC
ENDMODULE
