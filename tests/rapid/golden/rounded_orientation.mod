MODULE rounded_orientation
    CONST robtarget p0:=[[500,0,600],[0,0.708,0.708,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p1:=[[500,0,600],[0,0,0.99,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL p0,v500,fine,tool0;
        MoveL p1,v500,fine,tool0;
    ENDPROC
ENDMODULE
