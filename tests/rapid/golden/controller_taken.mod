MODULE controller_taken
    PROC main()
        IF OpMode()=1 AND RobOS() AND TaskRunRob() WaitTime 1;
        IF GetTaskName()="T_LEFT" WaitTime 2;
        WaitTime MaxRobSpeed();
    ENDPROC
ENDMODULE
