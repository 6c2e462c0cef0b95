MODULE parameters_by_reference
    CONST robtarget p:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PERS robtarget here:=[[1,2,3],[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    VAR num grid{2,3}:=[[1,2,3],[4,5,6]];
    PROC main()
        double grid{2,3};
        fill grid;
        WaitTime grid{2,3};
        WaitTime grid{1,1};
        here:=p;
        double here.trans.x;
        MoveL here,v100,fine,tool0;
    ENDPROC
    PROC double(INOUT num x)
        x:=2*x;
    ENDPROC
    PROC fill(VAR num m{*,*})
        m{1,1}:=Dim(m,1)*Dim(m,2);
    ENDPROC
ENDMODULE
