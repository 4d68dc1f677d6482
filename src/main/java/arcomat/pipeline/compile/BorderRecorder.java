package arcomat.pipeline.compile;

import arcomat.model.Port;
import arcomat.model.Value;
import arcomat.rt.Border;

import java.util.HashMap;
import java.util.List;
import java.util.Map;

/** Writes down what leaves compiled event-driven code. */
final class BorderRecorder extends Border {
    private record Stream(Port port, List<Value> values) {}

    private final JavaValues messages;
    private final Map<String, Stream> streams = new HashMap<>();

    BorderRecorder(JavaValues messages) {
        this.messages = messages;
    }

    void record(Port port, List<Value> values) {
        streams.put(port.name(), new Stream(port, values));
    }

    private void note(String port, Object message) {
        Stream stream = streams.get(port);
        if (stream != null) {
            stream.values.add(messages.fromJava(message, stream.port.type()));
        }
    }

    @Override
    public void sent(String port, int message) {
        note(port, message);
    }

    @Override
    public void sent(String port, long message) {
        note(port, message);
    }

    @Override
    public void sent(String port, boolean message) {
        note(port, message);
    }

    @Override
    public void sent(String port, char message) {
        note(port, message);
    }

    @Override
    public void sent(String port, double message) {
        note(port, message);
    }

    @Override
    public void sent(String port, Object message) {
        note(port, message);
    }
}
