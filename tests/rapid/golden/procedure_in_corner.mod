MODULE procedure_in_corner
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR num n;
    PROC main()
        MoveLSync p0,v500,z10,tool0,"atCorner";
        MoveL Offs(p0,n,0,0),v500,fine,tool0;
    ENDPROC
    PROC atCorner()
        n:=40;
        SetDO doA,1;
    ENDPROC
ENDMODULE
