package arcomat.sim.script;

import arcomat.sim.device.Key;
import arcomat.sim.device.SensorName;
import arcomat.sim.device.Stimulus;

/** Something that happens to a brick. */
public sealed interface Action {
    /** Makes it happen. */
    void perform(Receiver receiver);

    /** To whom it happens. */
    interface Receiver {
        /** A sensor is exposed to something from now on. */
        void expose(SensorName socket, Stimulus stimulus);

        /** A button goes down. */
        void press(Key key);

        /** A button comes up. */
        void release(Key key);

        /** The brick is switched off. */
        void stop();
    }

    /** A sensor is exposed to something from now on. */
    record Expose(SensorName socket, Stimulus stimulus) implements Action {
        @Override
        public void perform(Receiver receiver) {
            receiver.expose(socket, stimulus);
        }
    }

    /** A button goes down. */
    record Press(Key key) implements Action {
        @Override
        public void perform(Receiver receiver) {
            receiver.press(key);
        }
    }

    /** A button comes up. */
    record Release(Key key) implements Action {
        @Override
        public void perform(Receiver receiver) {
            receiver.release(key);
        }
    }

    /** The brick is switched off. */
    record End() implements Action {
        @Override
        public void perform(Receiver receiver) {
            receiver.stop();
        }
    }
}
