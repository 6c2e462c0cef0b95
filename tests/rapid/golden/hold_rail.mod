MODULE m
    CONST robtarget p:=[[500,0,500],[0,0,1,0],[0,0,0,0],[0,9E9,9E9,9E9,9E9,9E9]];
    PROC main()
        MoveJ p,v100,fine,tool0;
        Set doGrip;
        WaitTime 0.3;
        Weld;
        WaitTime 1; ! trajopt: hold rail
        WaitTime 2;
        Idle;
    ENDPROC
    PROC Weld()
        MoveL Offs(p,0,0,50),v100,fine,tool0;
    ENDPROC
    PROC Idle()
        WaitTime 3;
    ENDPROC
ENDMODULE
