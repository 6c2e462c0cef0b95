MODULE confdata_of_three
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[-1,0,2],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveL p0,v500,fine,tool0;
    ENDPROC
ENDMODULE
