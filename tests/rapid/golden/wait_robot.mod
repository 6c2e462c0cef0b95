MODULE wait_robot
    PERS bool taken:=FALSE;
    PROC main()
        WaitRob\InPos;
        WaitTime\InPos,0.5;
        WaitRob\ZeroSpeed;
        WaitTestAndSet taken;
        IF NOT TestAndSet(taken) WaitTime 1;
        taken:=FALSE;
        IF TestAndSet(taken) WaitTime 2;
        WaitTestAndSet taken;
    ENDPROC
ENDMODULE
