MODULE socket_answers
    VAR socketdev server;
    VAR socketdev client;
    VAR socketdev other;
    VAR string who;
    VAR string command;
    VAR num count;
    PROC main()
        SocketCreate server;
        SocketBind server,"127.0.0.1",1025;
        SocketListen server;
        SocketAccept server,client\ClientAddress:=who\Time:=WAIT_MAX;
        WHILE SocketGetStatus(client)<>2 DO
            WaitTime 99;
        ENDWHILE
        WHILE TRUE DO
            SocketReceive client\Str:=command\NoRecBytes:=count;
            TEST StrPart(command,1,3)
            CASE "GO ":
                WaitTime 10*count;
            CASE "END":
                SocketClose client;
                WaitTime SocketGetStatus(client)+SocketGetStatus(other);
                EXIT;
            ENDTEST
            SocketSend client\Str:="ok";
        ENDWHILE
    ENDPROC
ENDMODULE
