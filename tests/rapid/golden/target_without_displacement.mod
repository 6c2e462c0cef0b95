MODULE target_without_displacement
    CONST robtarget p0:=[[500,0,600],[0,0,1,0],[0,0,0,0],[10,9E9,9E9,9E9,9E9,9E9]];
    VAR robtarget a;
    VAR robtarget b;
    VAR robtarget c;
    PROC main()
        PDispSet [[1,2,3],[1,0,0,0]];
        EOffsSet [5,0,0,0,0,0];
        a:=ORobT(p0);
        b:=ORobT(p0\InPDisp);
        c:=ORobT(p0\InEOffs);
        PDispOff;
        EOffsOff;
        MoveL a,v500,fine,tool0;
        MoveL b,v500,fine,tool0;
        MoveL c,v500,fine,tool0;
    ENDPROC
ENDMODULE
