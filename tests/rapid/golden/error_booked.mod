MODULE error_booked
    VAR errnum ERR_EMPTY:=-1;
    VAR num stock;
    PROC main()
        BookErrNo ERR_EMPTY;
        WaitTime take(3);
    ERROR
        IF ERRNO=ERR_EMPTY THEN
            stock:=8;
            RETRY;
        ENDIF
    ENDPROC
    FUNC num take(num count)
        IF stock<count RAISE ERR_EMPTY;
        stock:=stock-count;
        RETURN stock;
    ENDFUNC
ENDMODULE
