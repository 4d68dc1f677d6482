package montiarc7.source;

/** What an original may have that cannot be said in Arcomat, or that somebody has to know. */
public enum Lack {
    UNREADABLE("MONT0001"),
    MODES("MONT0002"),
    TICKS_AND_EVENTS("MONT0003"),
    VARIABILITY("MONT0004"),
    STATEMENT("MONT0005"),
    EXPRESSION("MONT0006"),
    PARENTS("MONT0007"),
    SENT_TWICE("MONT0008"),
    STRUCTURE("MONT0009"),
    OPAQUE("MONT0010"),
    START("MONT0011"),
    NEVER("MONT0012"),
    MAP("MONT0013"),
    MAP_NOTE("MONT0014"),
    OUTSIDE("MONT0015"),
    UNCHECKED("MONT0016"),
    OPEN("MONT0017");

    private final String code;

    Lack(String code) {
        this.code = code;
    }

    public String code() {
        return code;
    }
}
