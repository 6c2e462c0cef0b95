MODULE module_to_load
    PROC main()
        Load\Dynamic,"HOME:/parts/module_to_load.mod";
        Load "HOME:"\File:="parts/other.mod";
    ENDPROC
ENDMODULE
