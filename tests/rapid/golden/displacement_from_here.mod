MODULE displacement_from_here
    CONST robtarget pOld:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pHere:=[[510,-20,630],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL pHere,v500,fine,tool0;
        PDispOn pOld,tool0;
        MoveL pOld,v500,fine,tool0;
        PDispAdd [[0,0,5],[1,0,0,0]];
        MoveL pOld,v500,fine,tool0;
    ENDPROC
ENDMODULE
