MODULE record_answer
    VAR iodev channel;
    VAR pos corner;
    VAR num shares{2};
    PROC main()
        ReadAnyBin channel,corner;
        ReadAnyBin channel,shares;
        MoveL [corner,[1,0,0,0],[0,0,0,0],[9E9,9E9,9E9,9E9,9E9,9E9]],v100,fine,tool0;
        WaitTime shares{2};
    ENDPROC
ENDMODULE
