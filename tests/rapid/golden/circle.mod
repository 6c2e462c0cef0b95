MODULE circle
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pTop:=[[600,100,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget pEnd:=[[700,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveJ p0,v500,fine,tool0;
        MoveC pTop,pEnd,v100,z10,tool0;
        MoveL p0,v100,fine,tool0;
    ENDPROC
ENDMODULE
