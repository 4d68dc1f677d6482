package mill;

/** What is open in a part of a part is open in the whole. */
component Town {
  port sync in int i, sync out int horn, siren, rest;
  Alarm alarm(loud = true);
  i -> alarm.i;
  alarm.horn -> horn;
  alarm.siren -> siren;
  alarm.rest -> rest;
}
