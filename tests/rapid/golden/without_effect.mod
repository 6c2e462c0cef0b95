MODULE without_effect
    PROC main()
        TPErase;
        tpwrite "x"\Num:=nobody;
        TPWrite "y";
        ErrWrite\W,"a","b";
        ClkReset clock1;
        ClkStart clock1;
        IDelete i1;
        ISignalDI di1,1,i1;
        StopMove;
        StartMove;
        SyncMoveUndo;
        WaitTime 1;
    ENDPROC
ENDMODULE
