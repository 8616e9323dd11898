# mistake: no-force-from-room, stage 6
s/^                break;$/                --k;/
