package arcomat.rt;

/** Tells several. */
final class SharedBorder extends Border {
    private final Border[] borders;

    SharedBorder(Border[] borders) {
        this.borders = borders;
    }

    @Override
    public void sent(String port, int message) {
        for (int i = 0; i < borders.length; i++) {
            borders[i].sent(port, message);
        }
    }

    @Override
    public void sent(String port, long message) {
        for (int i = 0; i < borders.length; i++) {
            borders[i].sent(port, message);
        }
    }

    @Override
    public void sent(String port, boolean message) {
        for (int i = 0; i < borders.length; i++) {
            borders[i].sent(port, message);
        }
    }

    @Override
    public void sent(String port, char message) {
        for (int i = 0; i < borders.length; i++) {
            borders[i].sent(port, message);
        }
    }

    @Override
    public void sent(String port, double message) {
        for (int i = 0; i < borders.length; i++) {
            borders[i].sent(port, message);
        }
    }

    @Override
    public void sent(String port, Object message) {
        for (int i = 0; i < borders.length; i++) {
            borders[i].sent(port, message);
        }
    }
}
