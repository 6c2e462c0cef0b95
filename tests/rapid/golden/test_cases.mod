MODULE test_cases
    VAR num n:=3;
    VAR pos here:=[1,2,3];
    PROC main()
        TEST n CASE 1,2: WaitTime 1; CASE 3,4: WaitTime 2; DEFAULT: WaitTime 3; ENDTEST
        TEST "b" CASE "a": WaitTime 1; CASE "b": WaitTime 4; ENDTEST
        TEST here
        CASE [0,0,0]: WaitTime 5;
        CASE [1,2,3]: WaitTime 6;
        ENDTEST
        IF n=3 WaitTime 7; IF n<>3 WaitTime 8; WaitTime 9;
    ENDPROC
ENDMODULE
