package arcomat.generate.template;

/** A template that cannot be read or filled in. */
public final class TemplateFailure extends RuntimeException {
    private static final long serialVersionUID = 1L;

    private final String template;
    private final int line;
    private final int column;

    TemplateFailure(String template, int line, int column, String reason) {
        super(reason);
        this.template = template;
        this.line = line;
        this.column = column;
    }

    public String template() {
        return template;
    }

    /** From 1; 0 where the place is not known. */
    public int line() {
        return line;
    }

    /** From 1; 0 where the place is not known. */
    public int column() {
        return column;
    }

    @Override
    public String toString() {
        return template + ":" + line + ":" + column + ": " + getMessage();
    }
}
