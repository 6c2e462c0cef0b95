MODULE undeclared_frames
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL p0,v500,fine,tGrip\WObj:=wPart;
        MoveL p0,v500,fine,tGrip;
    ENDPROC
ENDMODULE
