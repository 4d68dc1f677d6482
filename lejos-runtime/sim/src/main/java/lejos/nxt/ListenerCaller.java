package lejos.nxt;

/** Somebody with listeners. */
public interface ListenerCaller {
    /** Tells the listeners what there is now; what comes back is for those who watch. */
    int callListeners();
}
