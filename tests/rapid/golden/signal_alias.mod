MODULE signal_alias
    VAR signaldo doGrip;
    VAR signaldi diPart;
    PROC main()
        AliasIO "DO_17",doGrip;
        AliasIO diReal,diPart;
        Set doGrip;
        WaitTime 10+diPart;
        WaitDI diPart,1;
        WaitTime 20+diReal;
        AliasIOReset doGrip;
        Set doGrip;
    ENDPROC
ENDMODULE
