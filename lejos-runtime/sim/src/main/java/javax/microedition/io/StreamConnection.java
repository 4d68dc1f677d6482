package javax.microedition.io;

/** A connection with a stream in either direction. */
public interface StreamConnection extends InputConnection, OutputConnection {}
