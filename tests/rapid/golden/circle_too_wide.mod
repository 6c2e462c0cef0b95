MODULE circle_too_wide
    CONST robtarget p0:=[[600,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pVia:=[[400,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pEnd:=[[500,-100,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL p0,v500,fine,tool0;
        MoveC pVia,pEnd,v100,fine,tool0;
    ENDPROC
ENDMODULE
