MODULE outputs_in_corners
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p1:=[[600,100,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    CONST robtarget p2:=[[700,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveLDO p0,v500,z10,tool0,doA,1;
        IF DOutput(doA)=1 MoveJGO p1,v500,z10,tool0,goB\Value:=5;
        MoveLDO p0,v500,fine,tool0,doA,0;
        MoveCAO p1,p2,v500,fine,tool0,aoC,2.5;
    ENDPROC
ENDMODULE
