package arcomat.rt;

/** Remembers what some outputs have sent, in order. */
final class SentMessages extends Border {
    private static final int FIRST = 4;

    private final String[] ports;
    private int[] senders = new int[FIRST];
    private final Values messages = new Values();

    SentMessages(String[] ports) {
        this.ports = ports;
    }

    @Override
    public void sent(String port, int message) {
        sent(port, (long) message);
    }

    @Override
    public void sent(String port, long message) {
        if (isFrom(port)) {
            messages.add(message);
        }
    }

    @Override
    public void sent(String port, boolean message) {
        sent(port, Requirement.code(message));
    }

    @Override
    public void sent(String port, char message) {
        sent(port, (long) message);
    }

    @Override
    public void sent(String port, double message) {
        sent(port, Requirement.code(message));
    }

    @Override
    public void sent(String port, Object message) {
        if (isFrom(port)) {
            messages.add(message);
        }
    }

    /** Notes the output, if it is one of those. */
    private boolean isFrom(String port) {
        for (int i = 0; i < ports.length; i++) {
            if (ports[i].equals(port)) {
                note(i);
                return true;
            }
        }
        return false;
    }

    private void note(int port) {
        int count = messages.size();
        if (count == senders.length) {
            senders = Values.longer(senders);
        }
        senders[count] = port;
    }

    /** What each output has sent. */
    void showTo(Messages seen) {
        for (int port = 0; port < ports.length; port++) {
            for (int i = 0; i < messages.size(); i++) {
                if (senders[i] == port) {
                    seen.send(port, messages, i);
                }
            }
        }
    }

    void forget() {
        messages.cut(0);
    }
}
