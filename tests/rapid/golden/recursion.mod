MODULE recursion
    CONST robtarget p:=[[500,0,600],[0,0,1,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        IF tower(3)=7 THEN
            WaitTime 7;
        ENDIF
    ENDPROC
    FUNC num tower(num n)
        IF n=0 RETURN 0;
        MoveL Offs(p,10*n,0,0),v100,fine,tool0;
        RETURN 2*tower(n-1)+1;
    ENDFUNC
ENDMODULE
