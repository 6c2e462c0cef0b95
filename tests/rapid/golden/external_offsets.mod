MODULE external_offsets
    CONST jointtarget j:=[[0,0,0,0,30,0],[100,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[100,9E9,9E9,9E9,9E9,-0.0089]];
    PROC main()
        EOffsSet [25,5,0,0,0,0];
        MoveL p0,v500,fine,tool0;
        MoveAbsJ j,v500,fine,tool0;
        MoveAbsJ j\NoEOffs,v500,fine,tool0;
        MoveExtJ j,vlin100,fine;
        MoveExtJ j\UseEOffs,vlin100,fine;
        EOffsOff;
        MoveL p0,v500,fine,tool0;
    ENDPROC
ENDMODULE
