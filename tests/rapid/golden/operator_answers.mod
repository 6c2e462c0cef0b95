MODULE operator_answers
    VAR num key;
    VAR num count;
    VAR num pressed;
    VAR num broken:=9;
    VAR string msg;
    PROC main()
        TPReadFK key,"Go on?","Yes","No",stEmpty,stEmpty,stEmpty\MaxTime:=60\BreakFlag:=broken;
        TPReadFK key,"Again?","Yes","No",stEmpty,stEmpty,stEmpty;
        TPReadNum count,"How many?";
        UIMsgBox\Header:="Stop",msg\Buttons:=btnYesNo\Result:=pressed;
        UIMsgBox "Only to read";
        WaitTime 1000*key+100*count+10*pressed+UINumEntry(\Header:="n"\MinValue:=1)+broken;
        WaitTime UINumEntry();
        IF UIAlphaEntry()="box" WaitTime 1;
    ENDPROC
ENDMODULE
