"""Headings of tables of shots in the languages of golfers, as translated programs and people write them.

Only words that can mean nothing else are here; how they are spelled together does not count.
"""

from __future__ import annotations

_HEADINGS = {
    "speed": """Schlägerkopfgeschwindigkeit|Schlägerkopfgeschw|Schlägergeschwindigkeit|Schlägergeschw
        |Schlägerkopftempo|Vitesse club|Vitesse du club|Vitesse de club|Vitesse tête de club
        |Vitesse de la tête de club|Velocidad del palo|Velocidad de palo|Velocidad palo|Velocidad de la cabeza
        |Velocidad de la cabeza del palo|Velocidad cabeza palo|Velocità bastone|Velocità del bastone
        |Velocità testa bastone|Klubbhastighet|Klubbhuvudshastighet|Klubbhuvudhastighet|Køllehastighed
        |Køllehastighet|Clubsnelheid|Clubhoofdsnelheid|Velocidade do taco|ヘッドスピード|ヘッド速度|クラブスピード
        |クラブヘッドスピード|杆头速度|桿頭速度|挥杆速度|揮桿速度|球杆速度|헤드 스피드|클럽 스피드
        |클럽 헤드 스피드|클럽 속도""",
    "attack": """Eintreffwinkel|Angriffswinkel|Anstellwinkel|Angle d'attaque|Ángulo de ataque|Angolo di attacco
        |Angolo d'attacco|Attackvinkel|Anfaldsvinkel|Angrepsvinkel|Aanvalshoek|Ângulo de ataque|アタックアングル
        |アタック角|入射角|攻击角度|攻擊角度|攻击角|攻角|어택 앵글|어택앵글|입사각""",
    "path": """Schlägerpfad|Schwungbahn|Schlägerbahn|Chemin du club|Chemin de club|Trajectoire du club
        |Trayectoria del palo|Trayectoria de palo|Percorso bastone|Traiettoria bastone|Klubbana|Svingbana|Klubbväg
        |Køllebane|Clubpad|クラブパス|スイングパス|杆头路径|桿頭路徑|挥杆路径|揮桿路徑|클럽 패스|클럽 궤도
        |스윙 패스""",
    "loft": """Dynamischer Loft|Dyn Loft|Loft dynamique|Loft dinámico|Loft dinamico|Dynamiskt loft|Dynamisk loft
        |Dynamische loft|ダイナミックロフト|动态杆面倾角|動態桿面傾角|다이나믹 로프트|다이내믹 로프트""",
    "face": """Schlagflächenwinkel|Schlägerblattwinkel|Schlagflächenstellung|Angle de face|Angle de la face
        |Ángulo de cara|Ángulo de la cara|Angolo faccia|Angolo della faccia|Bladvinkel|Klubbladsvinkel
        |Klubbladvinkel|フェースアングル|フェース角|フェイスアングル|フェイス角|杆面角度|桿面角度|杆面角
        |페이스 앵글|페이스앵글|페이스 각도""",
    "ball_speed": """Ballgeschwindigkeit|Ballgeschw|Balltempo|Vitesse balle|Vitesse de balle|Vitesse de la balle
        |Velocidad de bola|Velocidad de la bola|Velocidad bola|Velocidad de la pelota|Velocità palla
        |Velocità della palla|Bollhastighet|Boldhastighed|Ballhastighet|Balsnelheid|Velocidade da bola
        |ボールスピード|ボール初速|ボール速度|初速|球速|球初速|볼 스피드|볼 속도""",
    "smash": """Smash Faktor|Facteur de smash|Smash facteur|Factor de smash|Fattore smash|ミート率
        |スマッシュファクター|击球效率|擊球效率|撞击系数|스매시 팩터|스매쉬 팩터|스매시팩터""",
    "launch": """Abflugwinkel|Startwinkel|Launchwinkel|Angle de lancement|Angle de départ|Angle de décollage
        |Ángulo de lanzamiento|Ángulo de salida|Angolo di lancio|Utgångsvinkel|Utslagsvinkel|Startvinkel
        |Udgangsvinkel|Utgangsvinkel|Lanceerhoek|Ângulo de lançamento|打ち出し角|打出角|打出し角|打ち出し角度
        |打出角度|起飞角|起飞角度|起飛角|起飛角度|发射角|发射角度|發射角|발사각|발사 각도|탄도각|런치 앵글""",
    "azimuth": """Abflugrichtung|Startrichtung|Direction de lancement|Direction de départ|Dirección de lanzamiento
        |Dirección de salida|Direzione di lancio|Utgångsriktning|Startriktning|Udgangsretning|Utgangsretning
        |Lanceerrichting|左右打ち出し角|左右打出角|打ち出し方向|打出方向|打出し方向|方向角|发射方向|起飞方向
        |發射方向|방향각|발사 방향|좌우 발사각""",
    "backspin": """Rückwärtsdrall|Rétro rotation|Bakspinn|Backspinn|バックスピン|バックスピン量|后旋|後旋|后旋转
        |백스핀|백 스핀""",
    "sidespin": """Seitendrall|Seitwärtsdrall|Rotation latérale|Sidspinn|Sidospinn|サイドスピン|サイドスピン量
        |侧旋|側旋|사이드스핀|사이드 스핀""",
    "total_spin": """Spinrate|Drehrate|Taux de rotation|Taux de spin|Vitesse de rotation|Giro|Tasa de giro
        |Velocidad de giro|Velocidad de rotación|Tasso di rotazione|Spinnhastighet|Spinn|Spinsnelheid|スピン量
        |スピンレート|トータルスピン|总旋转|總旋轉|旋转速度|自旋速率|스핀량|스핀 레이트|총 스핀|토탈 스핀""",
    "spin_axis": """Spinachse|Drehachse|Axe de rotation|Axe de spin|Eje de giro|Eje de rotación|Asse di rotazione
        |Spinnaxel|Spinaxel|Spinakse|Spinas|スピン軸|スピンアクシス|旋转轴|旋轉軸|스핀 축|스핀축""",
    "carry": """Carry Distanz|Carryweite|Flugweite|Fluglänge|Portée|Distance de carry|Vuelo|Distancia de vuelo
        |Distancia de carry|Distanza di volo|Carrylängd|Carryavstånd|Carrylængde|Carry afstand|キャリー
        |キャリー距離|飞行距离|飛行距離|落点距离|落點距離|캐리|캐리 거리|비거리""",
    "total": """Gesamtdistanz|Gesamtweite|Gesamtlänge|Distance totale|Distancia total|Distanza totale
        |Totalt avstånd|Total distans|Totallängd|Totale afstand|トータル|トータル距離|総飛距離|总距离|總距離
        |总码数|총 거리|총거리|총 비거리|토탈 거리""",
    "side": """Seitenabweichung Carry|Écart latéral|Déviation latérale|Desviación lateral|Deviazione laterale
        |Sidavvikelse|左右ブレ|左右幅|左右偏差|横向偏差|橫向偏差|좌우 편차|좌우편차""",
    "apex": """Scheitelhöhe|Scheitelpunkt|Maximale Höhe|Max Höhe|Hauteur maximale|Hauteur max|Altura máxima
        |Altezza massima|Höhe|Flughöhe|Hauteur|Höjd
        |Maxhöjd|Maximal höjd|最高到達点|最高点|最大高さ|最高飞行高度|最大高度|최고점|최고 높이
        |최대 높이""",
    "flight_time": """Flugzeit|Flugdauer|Temps de vol|Tiempo de vuelo|Tempo di volo|Flygtid|滞空時間|飞行时间
        |滞空时间|체공 시간|체공시간""",
    "landing_angle": """Landewinkel|Auftreffwinkel|Angle d'atterrissage|Angle de descente|Ángulo de aterrizaje
        |Ángulo de descenso|Ángulo de caída|Angolo di atterraggio|Landningsvinkel|Nedslagsvinkel|落下角|落下角度
        |着弾角|落地角度|落地角|下降角|착지각|낙하각|랜딩 앵글""",
}  # fmt: skip

CLUB = """Schläger|Schlägerart|Schlägertyp|Type de club|Palo|Tipo de palo|Bastone|Klubba|Klubb|Kølle|Maila|Taco
    |クラブ|番手|使用クラブ|球杆|球桿|球杆类型|클럽|클럽명|골프채"""
PLAYER = """Spieler|Spielername|Joueur|Nom du joueur|Jugador|Giocatore|Spelare|Spiller|Speler|Pelaaja|Jogador
    |プレーヤー|プレイヤー|選手|氏名|球员|球員|선수|플레이어"""


def names(text: str) -> tuple[str, ...]:
    """Return the names in a text, which bars part."""
    return tuple(each.strip() for each in text.replace("\n", "").split("|"))


FOREIGN_HEADINGS = {quantity: names(text) for quantity, text in _HEADINGS.items()}
"""The headings of each quantity."""
