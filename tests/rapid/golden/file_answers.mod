MODULE file_answers
    VAR iodev file;
    VAR num value;
    VAR string line;
    VAR rawbytes raw;
    PROC main()
        Open "HOME:"\File:="points.txt",file\Read;
        value:=ReadNum(file);
        WHILE value<9E36 DO
            WaitTime value;
            value:=ReadNum(file);
        ENDWHILE
        line:=ReadStr(file\Delim:=",");
        WHILE line<>"EOF" DO
            WaitTime StrLen(line);
            line:=ReadStr(file);
        ENDWHILE
        UnpackRawBytes raw\Network,1,value\IntX:=UINT;
        WaitTime value;
        Close file;
    ENDPROC
ENDMODULE
