MODULE displacement_set
    PERS wobjdata w:=[FALSE,TRUE,"",[[1000,0,0],[0.70710678,0,0,0.70710678]],[[0,0,50],[1,0,0,0]]];
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST jointtarget j:=[[0,0,0,0,30,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        PDispSet [[10,20,30],[1,0,0,0]];
        MoveL p0,v500,fine,tool0\WObj:=w;
        MoveAbsJ j,v500,fine,tool0;
        PDispOff;
        MoveL p0,v500,fine,tool0\WObj:=w;
    ENDPROC
ENDMODULE
