package mill;

/** What is open in a part of a part is open in the whole. */
component Town {
    feature alarmLeftHigh, alarmLeftLow, alarmRightHigh;
    port in Integer i, out Integer horn, out Integer siren, out Integer rest;
    component Alarm(loud = true, leftHigh = alarmLeftHigh, leftLow = alarmLeftLow,
            rightHigh = alarmRightHigh) alarm;
    constraint (true implies alarmLeftHigh);
    constraint (alarmLeftLow || alarmLeftHigh);
    constraint (true || alarmRightHigh);
    connect i -> alarm.i;
    connect alarm.horn -> horn;
    connect alarm.siren -> siren;
    connect alarm.rest -> rest;
}
