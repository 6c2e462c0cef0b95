MODULE external_offset_on
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p1:=[[500,0,600],[0,0,1,0],[0,0,0,0],[130,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        EOffsOn\ExeP:=p1,p0;
        MoveL p1,v500,fine,tool0;
        EOffsOff;
        MoveL p0,v500,fine,tool0;
        EOffsOn p1;
        MoveL p1,v500,fine,tool0;
    ENDPROC
ENDMODULE
